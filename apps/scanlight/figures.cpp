#include "apps/scanlight/figures.h"

#include <algorithm>

#include "apps/scanlight/picture.h"
#include "apps/scene/scene_setup.h"

namespace scanlight::apps {

namespace {

raster::Image8 draw_panel(const std::string& command_line, raster::Viewport size,
                          const Means& means) {
    SceneOptions options = parse_scene(command_line);
    options.size = size;
    const Models models = load_models(options);
    const render::Scene scene = scene_of(models, options);
    return byte_image(draw_picture(scene, options, means, {}), raster::Alpha::dropped);
}

void paste(raster::Image8& sheet, const raster::Image8& panel, int x) {
    for (int y = 0; y < panel.height(); ++y) {
        for (int i = 0; i < panel.width(); ++i) {
            std::ranges::copy(panel.pixel(i, y), sheet.pixel(x + i, y).begin());
        }
    }
}

}  // namespace

// clang-format off
const std::vector<Figure>& figures() {
    static const std::vector<Figure> all{
        {"shading",
         "Flat, Gouraud and Phong shading of the same polygons: facets; smooth but dull, the "
         "highlight caught only where it meets a vertex; a round highlight.",
         {"teapot:4 --shading flat",
          "teapot:4 --shading gouraud",
          "teapot:4 --shading phong"}},
        {"stages",
         "From wireframe to picture: all edges, hidden ones removed, flat shading with edges.",
         {"teapot:4 --wireframe",
          "teapot:4 --wireframe=hidden",
          "teapot:4 --wireframe=over --shading flat"}},
        {"flow",
         "The way of a picture: edges, hidden edges removed, flat, Gouraud and Phong shading, and at "
         "last texture and shadow.",
         {"teapot:4 --floor --zoom 0.9 --wireframe",
          "teapot:4 --floor --zoom 0.9 --wireframe=hidden",
          "teapot:4 --floor --zoom 0.9 --shading flat",
          "teapot:4 --floor --zoom 0.9 --shading gouraud",
          "teapot:4 --floor --zoom 0.9 --shading phong",
          "teapot:4 --floor --zoom 0.9 --shading phong --shadows zfail --light world:-1,2,1.5 "
          "--texture \"diffuse=marble bend=1.5 low=#28323c high=#f0ece4\""}},
        {"teapot-phong",
         "Newell's teapot, Phong shading.",
         {"teapot:10"}},
        {"shadows",
         "Two coloured lights, each with shadows of its own; where both are hidden, the ambient "
         "light alone is left.",
         {"teapot:6 --floor --shadows zfail --view 25,35 --zoom 0.75 --ambient 0.1 "
          "--light point:-3,5,3,#d89050 --light point:4,6,2,#4070c0",
          "teapot:6 --floor --shadows zfail --view 25,35 --zoom 0.75 --ambient 0.1 "
          "--light point:-3,5,3,#d89050",
          "teapot:6 --floor --shadows zfail --view 25,35 --zoom 0.75 --ambient 0.1 "
          "--light point:4,6,2,#4070c0"}},
        {"stencil",
         "A shadow, and the stencil buffer that made it: in how many shadow volumes each surface "
         "lies. The faces towards the light and those behind them count apart, and so does what "
         "they shadow of each other.",
         {"torus:24,12 --floor --shadows zfail --view 25,35 --zoom 0.7 --light point:3.5,1.6,-1",
          "torus:24,12 --floor --show stencil --view 25,35 --zoom 0.7 --light point:3.5,1.6,-1"}},
        {"zpass",
         "The eye in a shadow. Counting from the eye to the surface begins at 0 and lights what "
         "is dark; from infinity back to the surface (z-fail) it is right.",
         {"cube --floor --eye 1.4,-0.2,-3 --target 4,-1,1 --fov 70 --shadows zpass-from-zero "
          "--light point:-1,3,2.5",
          "cube --floor --eye 1.4,-0.2,-3 --target 4,-1,1 --fov 70 --shadows zfail "
          "--light point:-1,3,2.5"}},
        {"shadow-map",
         "By shadow volumes, exact at every pixel; by a z-buffer of the light's view, whose cells "
         "show at the shadow's edge; filtered, where each pixel has its share of 5 x 5 cells.",
         {"teapot:6 --floor --shadows zfail --view 25,35 --zoom 0.75 --light point:-3,5,3",
          "teapot:6 --floor --shadows map --shadow-map-size 384 --view 25,35 --zoom 0.75 "
          "--light point:-3,5,3",
          "teapot:6 --floor --shadows map --shadow-map-size 384 --shadow-pcf 5 --view 25,35 "
          "--zoom 0.75 --light point:-3,5,3"}},
        {"shadow-bias",
         "The bias of a shadow map, in its cells: with 0.1 surfaces shadow themselves; 1; with 12 "
         "shadows come loose from what casts them.",
         {"teapot:6 --floor --shadows map --shadow-bias 0.1 --shadow-map-size 384 --view 25,35 "
          "--zoom 0.75 --light point:-3,5,3",
          "teapot:6 --floor --shadows map --shadow-bias 1 --shadow-map-size 384 --view 25,35 "
          "--zoom 0.75 --light point:-3,5,3",
          "teapot:6 --floor --shadows map --shadow-bias 12 --shadow-map-size 384 --view 25,35 "
          "--zoom 0.75 --light point:-3,5,3"}},
        {"shadow-polygons",
         "The lit parts of polygons, cut out in the light's view by those over them, as polygons: a "
         "picture, its lit details, and those of two lights.",
         {"torus:16,8 --floor --shadows polygons --view 25,35 --zoom 0.7 --light point:3.5,1.6,-1",
          "torus:16,8 --floor --shadows polygons --show details --view 25,35 --zoom 0.7 "
          "--light point:3.5,1.6,-1",
          "cube --floor --shadows polygons --show details --view 25,35 --zoom 0.7 "
          "--light point:-2,3,1 --light point:2,3.5,-0.5"}},
        {"sphere-coarse",
         "A coarse sphere: its outline stays a polygon whatever the shading.",
         {"sphere:12,6 --shading flat",
          "sphere:12,6 --shading gouraud",
          "sphere:12,6 --shading phong"}},
        {"ambient",
         "Ambient light alone turns a sphere into a disc; diffuse light alone leaves the side "
         "away from the light black; both together.",
         {"sphere --ambient 1 --light 0,0,1,#000",
          "sphere --illumination lambert --ambient 0",
          "sphere --illumination lambert --ambient 0.3"}},
        {"exponents",
         "The exponent n = 5, 50, 500: the highlight shrinks.",
         {"sphere:48,24 --material \"kd=#305090 ks=0.8 n=5\"",
          "sphere:48,24 --material \"kd=#305090 ks=0.8 n=50\"",
          "sphere:48,24 --material \"kd=#305090 ks=0.8 n=500\""}},
        {"phong-blinn",
         "The same n = 20: (R.V)^n of Phong, (N.H)^n of Blinn, which is wider, and Blinn with 4n.",
         {"sphere:48,24 --illumination phong --material \"kd=#803020 ks=0.8 n=20\"",
          "sphere:48,24 --illumination blinn --material \"kd=#803020 ks=0.8 n=20\"",
          "sphere:48,24 --illumination blinn --material \"kd=#803020 ks=0.8 n=80\""}},
        {"grazing",
         "Grazing light on a floor: R.V stays round, N.H is stretched along the view.",
         {"plane:1 --eye 0,0.35,1.3 --target 0,-0.1,0 --fov 60 --light world:0,0.35,-1 "
          "--illumination phong --material \"kd=0.1 ks=0.9 n=20\"",
          "plane:1 --eye 0,0.35,1.3 --target 0,-0.1,0 --fov 60 --light world:0,0.35,-1 "
          "--illumination blinn --material \"kd=0.1 ks=0.9 n=80\""}},
        {"plastic-metal",
         "Phong's teapot is plastic: its highlights are white. Those of Cook and Torrance's copper "
         "and gold have the metal's colour.",
         {"teapot:8 --illumination phong --material \"kd=#b4573a ks=0.5 n=30\" --ambient 0.04 "
          "--light -0.7,0.7,1,#999 --light 1,0.3,0.2,#777 --light 0,-1,0.6,#555",
          "teapot:8 --illumination cook-torrance --metal copper --roughness 0.35 --ambient 0.04 "
          "--light -0.7,0.7,1,#999 --light 1,0.3,0.2,#777 --light 0,-1,0.6,#555",
          "teapot:8 --illumination cook-torrance --metal gold --roughness 0.3 --ambient 0.04 "
          "--light -0.7,0.7,1,#999 --light 1,0.3,0.2,#777 --light 0,-1,0.6,#555"}},
        {"towards-grazing",
         "Light on a floor at 45 and at 77 degrees: Phong's highlight stays as it is, Cook and "
         "Torrance's grows.",
         {"plane:1 --fov 40 --ambient 0.05 --eye 0,1.1,1.1 --target 0,0,0 --light world:0,1,-1,#888 "
          "--illumination phong --material \"kd=0.12 ks=0.4 n=40\"",
          "plane:1 --fov 40 --ambient 0.05 --eye 0,0.35,1.5 --target 0,0,0 "
          "--light world:0,0.35,-1.5,#888 --illumination phong --material \"kd=0.12 ks=0.4 n=40\"",
          "plane:1 --fov 40 --ambient 0.05 --eye 0,1.1,1.1 --target 0,0,0 --light world:0,1,-1,#888 "
          "--illumination cook-torrance --material kd=0.24",
          "plane:1 --fov 40 --ambient 0.05 --eye 0,0.35,1.5 --target 0,0,0 "
          "--light world:0,0.35,-1.5,#888 --illumination cook-torrance --material kd=0.24"}},
        {"roughness",
         "Gold whose facets have a slope of m = 0.15, 0.3, 0.6: the smoother, the smaller and "
         "brighter the highlight.",
         {"sphere:48,24 --illumination cook-torrance --metal gold --roughness 0.15 --ambient 0.1 "
          "--light -0.7,0.7,1,#888",
          "sphere:48,24 --illumination cook-torrance --metal gold --roughness 0.3 --ambient 0.1 "
          "--light -0.7,0.7,1,#888",
          "sphere:48,24 --illumination cook-torrance --metal gold --roughness 0.6 --ambient 0.1 "
          "--light -0.7,0.7,1,#888"}},
        {"facet-distributions",
         "Facets of one slope, m = 0.5, after Beckmann, Gauss, and by the power of a cosine.",
         {"sphere:48,24 --illumination cook-torrance --metal silver --roughness 0.5 --ambient 0.05 "
          "--light -0.7,0.7,1,#888 --distribution beckmann",
          "sphere:48,24 --illumination cook-torrance --metal silver --roughness 0.5 --ambient 0.05 "
          "--light -0.7,0.7,1,#888 --distribution gauss",
          "sphere:48,24 --illumination cook-torrance --metal silver --roughness 0.5 --ambient 0.05 "
          "--light -0.7,0.7,1,#888 --distribution cosine"}},
        {"fresnel",
         "What spheres of glass, copper and gold mirror of the light: glass little in the middle and "
         "all at the rim, where metals too lose their colour.",
         {"sphere:96,48 --illumination cook-torrance --show fresnel --background 0",
          "sphere:96,48 --illumination cook-torrance --show fresnel --background 0 --metal copper",
          "sphere:96,48 --illumination cook-torrance --show fresnel --background 0 --metal gold"}},
        {"frosted-pane",
         "A lamp behind a pane, to the right of its middle: nothing of it by Blinn, whose light is "
         "the local one of Whitted too; the lamp through frosted glass, and through opal, by Hall.",
         {"plane:1 --eye 0,1.6,0.9 --target 0,0,0 --fov 40 --ambient 0.08 "
          "--light point:0.1,-0.5,-0.1 --illumination blinn --material \"kd=0.3 ks=0.3 n=40\"",
          "plane:1 --eye 0,1.6,0.9 --target 0,0,0 --fov 40 --ambient 0.08 "
          "--light point:0.1,-0.5,-0.1 --illumination hall "
          "--material \"kd=0.3 ks=0.3 n=40 kt=0.7 nt=60\"",
          "plane:1 --eye 0,1.6,0.9 --target 0,0,0 --fov 40 --ambient 0.08 "
          "--light point:0.1,-0.5,-0.1 --illumination hall "
          "--material \"kd=0.3 ks=0.3 n=40 kt=0.5 nt=60 kdt=0.4\""}},
        {"lampshade",
         "A globe with a lamp in it, and another lamp in front: dark by Phong, aglow by Hall.",
         {"sphere:48,24 --illumination phong --material \"kd=#a08060 ks=0.2 n=30\" --ambient 0.1 "
          "--light point:0,-0.3,0,#888 --light -0.7,0.7,1,#333",
          "sphere:48,24 --illumination hall --material \"kd=#a08060 ks=0.2 n=30 kdt=#ffd090 kt=0.3 "
          "nt=20\" --ambient 0.1 --light point:0,-0.3,0,#888 --light -0.7,0.7,1,#333"}},
        {"lights",
         "Three coloured lamps on a white sphere: coloured lobes, mixed where they overlap.",
         {"sphere:48,24 --material \"kd=0.9 ks=0.3 n=60\" --ambient 0.02 --light 0,1,0.8,#ff2020 "
          "--light -0.9,-0.5,0.8,#20ff20 --light 0.9,-0.5,0.8,#2020ff"}},
        {"checkerboards",
         "A checkerboard laid on a plane, around a cylinder and around a sphere, whose squares "
         "pinch at the poles; and the squares of the mesh's own (u, v).",
         {"plane:1 --view 30,40 --texture \"diffuse=checker axis=y mapping=planar low=0.05\"",
          "cylinder:32 --texture \"diffuse=checker mapping=cylindrical low=0.05\"",
          "sphere:48,24 --texture \"diffuse=checker mapping=spherical low=0.05 count=16\"",
          "torus:48,24 --texture \"diffuse=checker repeat=3,1 low=0.05\""}},
        {"cylinder-inverse",
         "The way around a cylinder by the angle, and by the chapter's formula, which goes around "
         "twice and shows the front again as a mirror image.",
         {"cylinder:32 --view 60,20 --texture \"diffuse=stripes count=8 mapping=cylindrical low=#401808 high=#d06020\"",
          "cylinder:32 --view 60,20 "
          "--texture \"diffuse=stripes count=8 mapping=chapter-cylinder low=#401808 high=#d06020\""}},
        {"solid-textures",
         "Textures that fill space: wood, whose rings on the top go on as grain on the sides; "
         "marble; cubes.",
         {"cube --crease 60 --texture \"diffuse=wood axis=y low=#40200c high=#c08040\"",
          "teapot:8 --texture \"diffuse=marble low=#20242c high=#e8e4dc\"",
          "teapot:8 --texture \"diffuse=cubes low=0.05\""}},
        {"bump",
         "Blinn's wrinkled surface: the normals wave, the outline stays a circle. Beside it the "
         "same sphere smooth.",
         {"sphere:64,32 --texture \"bump=waves mapping=spherical repeat=2,1 count=12 height=0.02\"",
          "sphere:64,32"}},
        {"texture-attributes",
         "What a texture may change: the diffuse colour, the highlight, its exponent, the normal.",
         {"sphere:48,24 --texture \"diffuse=stripes count=12 low=0.1\" --material \"ks=0.6 n=30\"",
          "sphere:48,24 --texture \"specular=stripes count=12\" --material \"kd=#803020 ks=0.9 n=10\"",
          "sphere:48,24 --texture \"exponent=stripes count=12 low=0.1\" "
          "--material \"kd=#803020 ks=0.9 n=80\"",
          "sphere:48,24 --texture \"bump=marble height=0.1\" --material \"kd=#803020 ks=0.6 n=30\""}},
        {"environment",
         "A room mirrored in a teapot and in a ball, which show the room and not themselves; and a "
         "matt ball in the room's light alone.",
         {"teapot:10 --environment room --material \"kd=0.05 mirror=0.8\" --fov 50",
          "sphere:64,32 --environment room --material \"kd=#602010 ka=0.1 mirror=0.5 ks=0.5 n=60\" "
          "--fov 50",
          "sphere:64,32 --environment room --environment-light --ambient 0 --light 0,0,1,#000 "
          "--material \"kd=0.9\" --fov 50"}},
        {"refraction",
         "A room seen through a ball: straight through a thin one; bent by glass, which mirrors, "
         "too; and by a bubble in glass, at whose rim all light is reflected.",
         {"sphere:64,32 --environment room --material \"kd=0 ka=0 refract=0.9\" --ior 1 --fov 50",
          "sphere:64,32 --environment room --material \"kd=0 ka=0 refract=0.8 mirror=0.15 ks=0.6 "
          "n=200\" --ior 1.5 --fov 50 --view 100,10",
          "sphere:64,32 --environment room --material \"kd=0 ka=0 refract=0.9\" --ior 0.75 "
          "--fov 50"}},
        {"transparency",
         "A ring of coloured glass, each of its surfaces blended over what is behind it, nearest "
         "first; on a floor with shadows, of which glass casts none; and opaque stripes on glass.",
         {"torus:48,24 --view 20,40 --material \"kd=#c04020 ks=0.6 n=40 opacity=0.4\"",
          "torus:48,24 --view 20,25 --floor --shadows zfail --zoom 0.8 "
          "--material \"kd=#4060c0 ks=0.6 n=40 opacity=0.5\"",
          "torus:48,24 --view 20,40 --material \"kd=#30a040 ks=0.5 n=40\" "
          "--texture \"opacity=stripes count=24 low=0.2\""}},
        {"gouraud-1971",
         "Gouraud's intensity of 1971, I_p K_d (N.L) / (r + k) with k = 0.1: no highlight, and "
         "what is near the lamp is bright. Beside it Lambert's, the same at any distance.",
         {"torus --illumination gouraud71 --gouraud71-k 0.1 --shading gouraud "
          "--light point:0.5,1.2,1.2",
          "torus --illumination lambert --shading gouraud --light point:0.5,1.2,1.2"}},
        {"falloff",
         "A lamp low over a floor: constant, 1/r, 1/r^2.",
         {"plane:24 --view 20,35 --illumination lambert --light point:0,0.3,0,#888,constant",
          "plane:24 --view 20,35 --illumination lambert --light point:0,0.3,0,#888,inverse",
          "plane:24 --view 20,35 --illumination lambert --light point:0,0.3,0,#888,inverse-square"}},
        {"infinity",
         "Eye and lamp at their places, and both at infinity: there a floor is all one colour.",
         {"plane:8 --view 20,35 --light point:0.5,0.8,0.5 --material \"kd=#607060 ks=0.6 n=20\"",
          "plane:8 --view 20,35 --light point:0.5,0.8,0.5 --material \"kd=#607060 ks=0.6 n=20\" "
          "--distances infinite"}},
        {"samples",
         "The edges of a triangle with 1, 4 and 16 samples a pixel, averaged in linear light.",
         {"ngon:3 --view 10,20 --background 0.9",
          "ngon:3 --view 10,20 --background 0.9 --samples 4",
          "ngon:3 --view 10,20 --background 0.9 --samples 16"}},
        {"crease",
         "A cube with averaged normals looks like a pillow; a crease angle keeps its edges. A "
         "cylinder without and with one.",
         {"cube --crease 180",
          "cube --crease 60",
          "cylinder:24 --crease 180",
          "cylinder:24"}},
        {"normal-weights",
         "Vertex normals of a cone with its base: the faces' mean, weighted by area, where the "
         "base outweighs all, and by angle.",
         {"cone:12 --crease 180 --normals mean",
          "cone:12 --crease 180 --normals area",
          "cone:12 --crease 180 --normals angle"}},
        {"lost-highlight",
         "A highlight inside a polygon: Gouraud loses it, Phong finds it; Gouraud again, on 64 "
         "times as many triangles.",
         {"icosphere:1 --shading gouraud --material \"kd=#306030 ks=0.9 n=60\"",
          "icosphere:1 --shading phong --material \"kd=#306030 ks=0.9 n=60\"",
          "icosphere:4 --shading gouraud --material \"kd=#306030 ks=0.9 n=60\""}},
        {"orientation",
         "Bilinear interpolation of a square's four corners depends on how it lies on the screen; "
         "cut into triangles it does not, but shows the cut.",
         {"cube --crease 180 --shading gouraud --illumination lambert --ambient 0 "
          "--light 1,0.2,0.3 --view 40,30 --interpolation bilinear",
          "cube --crease 180 --shading gouraud --illumination lambert --ambient 0 "
          "--light 1,0.2,0.3 --view 40,30 --interpolation triangulated"}},
        {"perspective",
         "A lamp over the middle of a floor of four squares, Gouraud-shaded: even over the object, "
         "and even over the screen as in the textbook, which draws the light towards the eye.",
         {"plane:2 --shading gouraud --eye 0,0.3,1.05 --target 0,-0.35,0 --fov 85 "
          "--illumination lambert --ambient 0.03 --material kd=0.9 "
          "--light point:0,0.3,0,#555,inverse-square --wireframe=over --perspective correct",
          "plane:2 --shading gouraud --eye 0,0.3,1.05 --target 0,-0.35,0 --fov 85 "
          "--illumination lambert --ambient 0.03 --material kd=0.9 "
          "--light point:0,0.3,0,#555,inverse-square --wireframe=over --perspective affine"}},
        {"concave",
         "Polygons of many corners, concave ones too, are filled as they are.",
         {"star:5 --view 0,0 --shading flat",
          "star:9 --view 20,30 --wireframe=over",
          "ngon:7 --view -20,10 --shading flat"}},
        {"shapes-solids",
         "Cube, tetrahedron and octahedron.",
         {"cube",
          "tetrahedron",
          "octahedron"}},
        {"shapes-round",
         "Icosphere, torus and cone.",
         {"icosphere:3",
          "torus",
          "cone"}},
        {"cull",
         "All polygons; back faces left out; front faces left out, which opens the view inside.",
         {"cylinder:16 --view 30,40 --cull none",
          "cylinder:16 --view 30,40 --cull back",
          "cylinder:16 --view 30,40 --cull front"}},
        {"sides",
         "The inside of a cylinder: lit on the front of each polygon only, and on the side seen.",
         {"cylinder:24 --view 30,40 --cull front --sides one --light 0.3,0.5,1",
          "cylinder:24 --view 30,40 --cull front --sides two --light 0.3,0.5,1"}},
        {"projections",
         "Perspective with a wide and a narrow field of view, and orthographic.",
         {"cube --fov 90",
          "cube --fov 20",
          "cube --projection orthographic"}},
        {"close-up",
         "The near plane and the picture's borders cut polygons without cracks.",
         {"teapot:6 --eye 1.45,0.5,0.3 --target 0.2,0,0 --fov 100",
          "sphere:24,12 --eye 0.2,0.1,0 --target 1,0.3,0.4 --fov 100"}},
    };
    return all;
}
// clang-format on

raster::Image8 draw_figure(const Figure& figure, raster::Viewport panel_size, const Means& means) {
    const int panels = static_cast<int>(figure.panels.size());
    raster::Image8 sheet(panel_size.width * panels, panel_size.height, 3);
    for (int i = 0; i < panels; ++i) {
        paste(sheet, draw_panel(figure.panels[static_cast<std::size_t>(i)], panel_size, means),
              i * panel_size.width);
    }
    return sheet;
}

}  // namespace scanlight::apps
