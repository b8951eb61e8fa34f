// What holds of all lessons, and the law that each of them shows.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <glm/common.hpp>

#include "apps/demo/lesson.h"
#include "apps/demo/plane_in_picture.h"
#include "apps/demo/settings.h"
#include "apps/demo/stage.h"
#include "apps/demo/walk.h"
#include "apps/scene/usage_error.h"
#include "mesh/corner_text.h"
#include "raster/srgb.h"
#include "tests/demo/all_screens.h"
#include "tests/golden/golden.h"

namespace scanlight::demo {
namespace {

constexpr raster::Viewport golden_panel{160, 120};

class EachLesson : public testing::TestWithParam<Lesson> {};

TEST_P(EachLesson, LooksAsAccepted) {
    const Lesson& lesson = GetParam();
    const Screen screen = lesson.draw(starting_settings(lesson), golden_panel, one_thread);
    EXPECT_TRUE(golden::matches("lessons/" + lesson.name, picture_of(screen)));
}

TEST_P(EachLesson, LooksTheSameByTheTextbooksWalk) {
    const Lesson& lesson = GetParam();
    const Settings settings = starting_settings(lesson);
    const apps::Means textbook{apps::DrawPath::textbook, {}};
    EXPECT_TRUE(picture_of(lesson.draw(settings, small_panel, one_thread)) ==
                picture_of(lesson.draw(settings, small_panel, textbook)));
}

TEST_P(EachLesson, DrawsAtBothEndsOfEachControl) {
    const Lesson& lesson = GetParam();
    for (const Settings& settings : ends_of_controls(lesson)) {
        const Screen screen = lesson.draw(settings, small_panel, one_thread);
        ASSERT_FALSE(screen.panels.empty());
        for (const Panel& panel : screen.panels)
            EXPECT_FALSE(panel.command.empty());
        for (const Number& number : screen.numbers)
            EXPECT_TRUE(std::isfinite(number.value)) << number.key;
        for (const Plot& plot : screen.plots)
            EXPECT_LT(plot.x.low, plot.x.high);
    }
}

TEST_P(EachLesson, StartsAtAStop) {
    for (const Control& control : GetParam().controls) {
        if (std::holds_alternative<Corners>(control.kind))
            continue;  // these start as a choice says
        const double start = starting_settings(GetParam()).at(control.name);
        EXPECT_EQ(std::ranges::count(stops_of(control), start), 1) << control.name;
    }
}

/// What the command line makes of a control at this text.
double taken(const Lesson& lesson, const Control& control, const std::string& text) {
    Settings settings;
    set(settings, lesson, control.name + "=" + text);
    return settings.at(control.name);
}

TEST_P(EachLesson, EachStopIsWhatItsLabelShows) {
    for (const Control& control : GetParam().controls) {
        for (const double stop : stops_of(control)) {
            EXPECT_EQ(held(control, stop), stop) << control.name;
            EXPECT_EQ(taken(GetParam(), control, value_text(control, stop)), stop) << control.name;
        }
    }
}

TEST_P(EachLesson, StopsAreEvenlySpaced) {
    for (const Control& control : GetParam().controls) {
        const auto stops = stops_of(control);
        for (std::size_t i = 2; i < stops.size(); ++i)
            EXPECT_NEAR(stops[i] - stops[i - 1], stops[1] - stops[0], 1e-9) << control.name;
    }
}

/// Whether two screens show different pictures, marks, numbers, or values along a walk.
bool differ(const Screen& a, const Screen& b) {
    if (!(picture_of(a) == picture_of(b))) return true;
    if (!std::ranges::equal(a.numbers, b.numbers, {}, &Number::value, &Number::value)) return true;
    return a.walked && b.walked && a.walked->steps.names != b.walked->steps.names;
}

/// From its first stop to its last, the others standing as in `others`.
bool changes(const Lesson& lesson, const Control& control, const Settings& others) {
    const auto ends = at_ends(lesson, control, others);
    return differ(lesson.draw(ends.front(), small_panel, one_thread),
                  lesson.draw(ends.back(), small_panel, one_thread));
}

TEST_P(EachLesson, EachControlChangesWhatIsShown) {
    const Lesson& lesson = GetParam();
    for (const Control& control : lesson.controls) {
        const auto all = ends_of_controls(lesson);
        EXPECT_TRUE(std::ranges::any_of(all, [&](const Settings& others) {
            return changes(lesson, control, others);
        })) << control.name;
    }
}

TEST_P(EachLesson, ItsCornersStartWhereCornersCanBe) {
    for (const Control& control : GetParam().controls) {
        const auto* corners = std::get_if<Corners>(&control.kind);
        if (corners == nullptr) continue;
        const auto& choice = std::get<Choice>(control_named(GetParam(), corners->choice).kind);
        EXPECT_EQ(corners->starts.size(), choice.words.size());
        for (const Polygon& polygon : corners->starts) {
            for (const glm::dvec2& corner : polygon)
                EXPECT_EQ(held(*corners, corner), corner);
        }
    }
}

TEST_P(EachLesson, NamesPlacesThatAreInTheSource) {
    for (const SourcePlace& place : GetParam().places) {
        std::ifstream file(std::string(SCANLIGHT_TESTS_DIR "/../") + place.file);
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        const std::string name = place.function.substr(place.function.rfind(':') + 1);
        EXPECT_NE(text.find(name), std::string::npos) << place.file << ": " << place.function;
    }
}

INSTANTIATE_TEST_SUITE_P(Lessons, EachLesson, testing::ValuesIn(lessons()), lesson_test_name);

// ---- law by law

double number_of(const Screen& screen, const std::string& key) {
    const auto found = std::ranges::find(screen.numbers, key, &Number::key);
    if (found == screen.numbers.end()) ADD_FAILURE() << "no number " << key;
    return found == screen.numbers.end() ? 0.0 : found->value;
}

Screen drawn(const std::string& name, const std::vector<std::string>& assignments,
             raster::Viewport size = small_panel) {
    const Lesson& lesson = lesson_named(name);
    Settings settings = starting_settings(lesson);
    for (const std::string& assignment : assignments)
        set(settings, lesson, assignment);
    return lesson.draw(settings, size, one_thread);
}

TEST(LostHighlight, ErrorFallsWithSubdivision) {
    const Screen screen = drawn("lost-highlight", {});
    const auto& points = screen.plots.front().curves.front().points;
    for (std::size_t level = 3; level < points.size(); ++level)
        EXPECT_LT(points[level].y, 0.5 * points[level - 1].y) << level;
}

TEST(LostHighlight, CoarseGouraudIsDullerThanPhong) {
    const Screen screen = drawn("lost-highlight", {"level=1"});
    EXPECT_LT(number_of(screen, "peak-gouraud"), 0.5 * number_of(screen, "peak-phong"));
}

TEST(MachBands, FlatBendsMoreThanGouraudAndGouraudMoreThanPhong) {
    const Screen screen = drawn("mach-bands", {}, {320, 240});
    EXPECT_GT(number_of(screen, "bend-flat"), 10 * number_of(screen, "bend-gouraud"));
    EXPECT_GT(number_of(screen, "bend-gouraud"), number_of(screen, "bend-phong"));
    EXPECT_GT(number_of(screen, "overshoot-flat"), number_of(screen, "overshoot-gouraud"));
}

TEST(MachBands, PhongBendsLessThanGouraudWhereverTheCut) {
    for (const char* cut : {"0.3", "0.4", "0.5", "0.6"}) {
        const Screen screen = drawn("mach-bands", {std::string("cut=") + cut}, {320, 240});
        EXPECT_LT(number_of(screen, "bend-phong"), 0.5 * number_of(screen, "bend-gouraud")) << cut;
    }
}

TEST(Orientation, BilinearCentreTurnsWithTheQuadAndTriangulatedStays) {
    const Screen screen = drawn("orientation", {});
    EXPECT_GT(number_of(screen, "range-bilinear"), 0.1);
    EXPECT_LT(number_of(screen, "range-triangulated"), 0.002);
}

TEST(Perspective, NoErrorWhereTheDepthIsEqual) {
    EXPECT_LT(number_of(drawn("perspective", {"azimuth=0"}), "worst-texels"), 0.01);
    EXPECT_GT(number_of(drawn("perspective", {"azimuth=27"}), "worst-texels"), 5.0);
}

TEST(AveragedNormals, ASmallCreaseAngleKeepsFaceNormals) {
    for (const auto* lean : {"lean-lid", "lean-side"}) {
        EXPECT_LT(number_of(drawn("averaged-normals", {"crease=0"}), lean), 0.1);
        EXPECT_GT(number_of(drawn("averaged-normals", {"crease=180"}), lean), 25.0);
    }
}

TEST(AveragedNormals, ByAreaTheLidIsBentLeast) {
    const auto lean = [](const std::string& weighting) {
        return number_of(drawn("averaged-normals", {"crease=180", "weighting=" + weighting}),
                         "lean-lid");
    };
    EXPECT_LT(lean("area"), lean("angle"));
    EXPECT_LT(lean("angle"), lean("mean"));
}

TEST(AveragedNormals, SmoothingSharesVertices) {
    EXPECT_GT(number_of(drawn("averaged-normals", {"crease=0"}), "vertices"),
              number_of(drawn("averaged-normals", {"crease=180"}), "vertices"));
}

TEST(Silhouette, GapIsThatOfTheFormula) {
    for (const char* slices : {"6", "12", "24"}) {
        const Screen screen = drawn("silhouette", {std::string("slices=") + slices}, {320, 240});
        EXPECT_NEAR(number_of(screen, "gap"), number_of(screen, "sagitta"), 1.0) << slices;
    }
}

TEST(PhongTerms, AddUpToTheSum) {
    const Screen screen = drawn("phong-terms", {});
    const auto& curves = screen.plots.front().curves;
    ASSERT_EQ(curves.size(), 4u);
    for (std::size_t i = 0; i < curves[3].points.size(); ++i) {
        if (std::isnan(curves[3].points[i].y)) continue;  // no surface
        const double sum = curves[0].points[i].y + curves[1].points[i].y + curves[2].points[i].y;
        EXPECT_NEAR(curves[3].points[i].y, sum, 1e-5);
    }
}

TEST(PhongTerms, FourTimesTheExponentMatches) {
    const auto term = [](const std::string& model) {
        return number_of(drawn("phong-terms", {"model=" + model}, {320, 240}), "highlight-term");
    };
    EXPECT_GT(term("n-h"), term("r-v"));
    EXPECT_NEAR(term("n-h-matched"), term("r-v"), 0.1);
}

TEST(PhongTerms, AreToldOfAPixelThatShowsTheTeapot) {
    for (const raster::Viewport size : {raster::Viewport{300, 60}, {60, 240}, {320, 240}})
        EXPECT_GT(number_of(drawn("phong-terms", {}, size), "n-l"), 0.1) << size.width;
}

TEST(CookTorrance, MetalsMirrorInTheirColour) {
    const Screen copper = drawn("cook-torrance", {"metal=copper"});
    EXPECT_GT(number_of(copper, "f-red"), number_of(copper, "f-blue") + 0.2);
    const Screen silver = drawn("cook-torrance", {"metal=silver"});
    EXPECT_NEAR(number_of(silver, "f-red"), number_of(silver, "f-blue"), 0.1);
}

TEST(CookTorrance, TheHighlightFollowsFromTheNumbersShown) {
    const Screen screen = drawn("cook-torrance", {}, {320, 240});
    const auto of = [&](const char* key) { return number_of(screen, key); };
    const double facets = of("d") * of("g") / (4.0 * of("n-l") * of("n-v"));
    EXPECT_GT(of("r-red"), 0.1);
    EXPECT_NEAR(of("r-red"), facets * of("f-red"), 1e-9);
    EXPECT_NEAR(of("r-blue"), facets * of("f-blue"), 1e-9);
    const double open = 2.0 * of("n-h") * std::min(of("n-v"), of("n-l")) / of("v-h");
    EXPECT_NEAR(of("g"), std::min(1.0, open), 1e-9);
}

TEST(CookTorrance, RougherFacetsLeanMore) {
    const auto density = [](const std::string& m) {
        return drawn("cook-torrance", {"m=" + m}).plots.front().curves.front().points.front().y;
    };
    EXPECT_GT(density("0.1"), density("0.6"));
}

TEST(ShadowVolumes, ZpassGoesWrongOnlyInsideAVolume) {
    EXPECT_EQ(number_of(drawn("shadow-volumes", {"eye=0"}), "wrong-pixels"), 0.0);
    EXPECT_GT(number_of(drawn("shadow-volumes", {"eye=1"}), "wrong-pixels"), 1000.0);
}

TEST(ShadowVolumes, TheListAddsUpToTheCounts) {
    const Screen outside = drawn("shadow-volumes", {"eye=0", "x=0.6"});
    EXPECT_EQ(number_of(outside, "count-zpass"), number_of(outside, "count-zfail"));
    const Screen inside = drawn("shadow-volumes", {"eye=1", "x=0.3"});
    EXPECT_NE(number_of(inside, "count-zpass"), number_of(inside, "count-zfail"));
    EXPECT_EQ(inside.tables.front().rows.back().back(), "0");  // all that is entered is left
}

TEST(Transparency, TheEngineBlendsByTheFormula) {
    for (const char* opacity : {"0.1", "0.5", "0.9"}) {
        const Screen screen = drawn("transparency", {std::string("opacity=") + opacity});
        EXPECT_LT(number_of(screen, "engine-difference"), 1e-5) << opacity;
    }
}

TEST(Transparency, OrderMattersMoreTheMoreOpaque) {
    const auto difference = [](const std::string& opacity) {
        return number_of(drawn("transparency", {"opacity=" + opacity}), "order-difference");
    };
    EXPECT_LT(difference("0.1"), difference("0.5"));
    EXPECT_LT(difference("0.5"), difference("0.9"));
}

TEST(Mappings, BumpsLeaveTheOutline) {
    const Screen screen = drawn("mappings", {"surface=bump", "mapping=spherical"});
    EXPECT_EQ(number_of(screen, "covered-plain"), number_of(screen, "covered-textured"));
    EXPECT_GT(number_of(screen, "changed"), 100.0);
    EXPECT_GT(number_of(screen, "covered-displaced"), number_of(screen, "covered-textured"));
}

// ---- the walk

TEST(EdgeTableWalk, StoresEachPixelOfEachSpanOnce) {
    const Screen screen = drawn("edge-table", {"polygon=star"});
    const auto& trace = screen.walked->steps.trace;
    std::set<std::pair<int, int>> stored;
    std::size_t pixels = 0;
    for (const WalkStep& step : walk_of(trace)) {
        if (step.kind != WalkStep::Kind::pixel) continue;
        ++pixels;
        stored.insert({step.x, trace.scanlines[step.line].y});
    }
    std::size_t covered = 0;
    for (const auto& line : trace.scanlines) {
        for (const auto& span : line.spans)
            covered += static_cast<std::size_t>(span.x_end - span.x_begin);
    }
    EXPECT_EQ(pixels, covered);
    EXPECT_EQ(stored.size(), covered);
}

TEST(EdgeTableWalk, IncrementsLeadToTheEngineOwnPixels) {
    const Screen screen = drawn("edge-table", {"polygon=quad", "shading=gouraud"});
    const auto& [steps, picture] = *screen.walked;
    for (const WalkStep& step : walk_of(steps.trace)) {
        if (step.kind != WalkStep::Kind::pixel) continue;
        const auto& line = steps.trace.scanlines[step.line];
        const double value = numbers_at(line.spans[step.span], step.x).values.at(0);
        const int drawn_as = picture.pixel(step.x, line.y)[0];
        EXPECT_NEAR(drawn_as, raster::srgb_from_linear(static_cast<float>(value)), 1)
            << step.x << "," << line.y;
    }
}

TEST(EdgeTableWalk, AnyStepBeyondTheLastIsTheLast) {
    const auto picture = [](const std::string& step) {
        return picture_of(drawn("edge-table", {"step=" + step}));
    };
    EXPECT_TRUE(picture("399") == picture("400"));
    EXPECT_FALSE(picture("30") == picture("31"));
}

// ---- the polygon's corners

/// A quad, a concave one, one that crosses itself, and one with level edges.
const std::vector<std::string> moved_polygons{
    "0.1,1.12:-2.35,1.24:-0.1,-1.12:1.6,-0.28", "0,1.12:-1.35,-0.92:0,0:1.35,-0.92",
    "-1.5,-0.96:1.5,0.8:1.5,-0.96:-1.5,0.92", "-1,0.4:-1,-0.4:1,-0.4:1,0.4"};

Screen with_corners(const std::string& corners, const std::string& shading = "gouraud") {
    return drawn("edge-table", {"corners=" + corners, "shading=" + shading});
}

/// In pixels of the grid.
std::vector<glm::dvec2> seen_corners(const Screen& screen) {
    std::vector<glm::dvec2> corners;
    for (const auto& corner : screen.walked->steps.corners)
        corners.emplace_back(corner.x, corner.y);
    return corners;
}

/// The rows whose centres an edge crosses, from the upper end, which counts, to the lower.
int rows_crossed(const glm::dvec2& a, const glm::dvec2& b) {
    const auto first_centre = [](double y) { return static_cast<int>(std::ceil(y - 0.5)); };
    return std::abs(first_centre(a.y) - first_centre(b.y));
}

TEST(EdgeTableCorners, EachEdgeIsInTheTableForTheRowsThatItCrosses) {
    for (const std::string& corners : moved_polygons) {
        const Screen screen = with_corners(corners);
        const auto seen = seen_corners(screen);
        std::map<std::uint32_t, int> rows;
        for (const auto& edge : screen.walked->steps.trace.edge_table)
            rows[edge.index] += edge.y_end - edge.y_begin;
        for (std::uint32_t i = 0; i < seen.size(); ++i)
            EXPECT_EQ(rows[i], rows_crossed(seen[i], seen[(i + 1) % seen.size()])) << corners << i;
    }
}

/// By the definition: whether a ray to the left crosses the outline an odd number of times.
bool is_inside(const std::vector<glm::dvec2>& polygon, const glm::dvec2& p) {
    bool inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 a = polygon[i];
        const glm::dvec2 b = polygon[(i + 1) % polygon.size()];
        if ((a.y > p.y) == (b.y > p.y)) continue;
        if (a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) < p.x) inside = !inside;
    }
    return inside;
}

/// Inside by a hair where it lies on an upper or left edge.
glm::dvec2 centre_of(int x, int y) {
    return {x + 0.5 + 1e-7, y + 0.5 + 1e-7};
}

TEST(EdgeTableCorners, StoredAreThePixelsWhoseCentresAreInsideByEvenAndOdd) {
    for (const std::string& corners : moved_polygons) {
        const Screen screen = with_corners(corners);
        const auto seen = seen_corners(screen);
        std::set<std::pair<int, int>> stored;
        for (const auto& line : screen.walked->steps.trace.scanlines) {
            for (const auto& span : line.spans) {
                for (int x = span.x_begin; x < span.x_end; ++x)
                    stored.insert({x, line.y});
            }
        }
        for (int y = 0; y < 16; ++y) {
            for (int x = 0; x < 24; ++x)
                EXPECT_EQ(stored.contains({x, y}), is_inside(seen, centre_of(x, y)))
                    << corners << " at " << x << "," << y;
        }
    }
}

TEST(EdgeTableCorners, AreWhereTheHandlesAre) {
    for (const std::string& corners : moved_polygons) {
        const Screen screen = with_corners(corners);
        const auto seen = seen_corners(screen);
        const double cell = screen.panels.front().picture.width() / 24.0;
        const auto& handles = *screen.handles;
        const glm::dvec2 first = mesh::parse_corners(corners, "corners").front();
        const glm::dvec2 at = mapped(handles.picture_from_plane, first) / cell;
        EXPECT_NEAR(at.x, seen.front().x, 1e-9) << corners;
        EXPECT_NEAR(at.y, seen.front().y, 1e-9) << corners;
        EXPECT_EQ(4.0 * seen.front(), glm::round(4.0 * seen.front())) << "quarters of a pixel";
    }
}

TEST(EdgeTableCorners, OneMovedLeavesTheOthersWhereTheyWere) {
    const auto before = seen_corners(with_corners("0.1,1.12:-1.7,0.2:-0.1,-1.12:1.6,-0.28"));
    const auto after = seen_corners(with_corners("0.1,1.12:-2.3,1.2:-0.1,-1.12:1.6,-0.28"));
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t i = 0; i < before.size(); ++i)
        EXPECT_EQ(before[i] == after[i], i != 1) << i;
}

TEST(EdgeTableCorners, DrawTheSameByTheTextbooksWalk) {
    const Lesson& lesson = lesson_named("edge-table");
    for (const std::string& corners : moved_polygons) {
        Settings settings = starting_settings(lesson);
        set(settings, lesson, "corners=" + corners);
        const apps::Means textbook{apps::DrawPath::textbook, {}};
        EXPECT_TRUE(lesson.draw(settings, small_panel, one_thread).walked->picture ==
                    lesson.draw(settings, small_panel, textbook).walked->picture)
            << corners;
    }
}

TEST(EdgeTableCorners, OfNothingToFillAreRefused) {
    for (const char* corners : {"0,0:1,0.04:2,0.08", "0,0:0.05,0.04:0,0.04", "1,1:1,1:1,1"})
        EXPECT_ANY_THROW(with_corners(corners)) << corners;
}

TEST(EdgeTableCorners, GoBackWhenAPolygonIsChosen) {
    const Lesson& lesson = lesson_named("edge-table");
    Settings settings = starting_settings(lesson);
    set(settings, lesson, "corners=0,1:-1,-1:1,-1");
    EXPECT_EQ(assignments_of(lesson, settings), std::vector<std::string>{"corners=0,1:-1,-1:1,-1"});
    set(settings, lesson, "polygon=quad");
    EXPECT_EQ(settings, starting_settings(lesson));
}

// ---- controls

TEST(Settings, CornersAreTakenAtTheirPlaces) {
    const Lesson& lesson = lesson_named("edge-table");
    Settings settings = starting_settings(lesson);
    const auto message_of = [&](const std::string& corners) -> std::string {
        try {
            set(settings, lesson, "corners=" + corners);
        } catch (const std::exception& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(message_of("0,1:-2.35,-1:2.35,-1.24"), "");
    EXPECT_EQ(text_of(control_named(lesson, "corners"), settings), "0,1:-2.35,-1:2.35,-1.24");
    EXPECT_EQ(message_of("0,1.23:1,0:0,0"),
              "corners '0,1.23': expected 0,1.24, the nearest place of a corner");
    EXPECT_EQ(message_of("0,1:-2.4,0:0,0"),
              "corners '-2.4,0': expected -2.35,0, the nearest place of a corner");
    EXPECT_EQ(message_of("0,1:1,0"), "corners: 2 corners, expected 3 to 64 as X,Y:X,Y:X,Y");
    EXPECT_EQ(message_of("0,1:1,0:nan,0"),
              "corners: \"nan,0\" is no corner X,Y of two numbers from -1000 to 1000");
}

TEST(Settings, TakeWhatTheyShow) {
    const Lesson& lesson = lesson_named("mach-bands");
    Settings settings = starting_settings(lesson);
    set(settings, lesson, "cut=0.57");
    EXPECT_EQ(settings.at("cut"), 0.57);
    EXPECT_THROW(set(settings, lesson, "cut=0.5712345"), apps::UsageError);
}

TEST(Settings, WrongOnesSayWhatWasExpected) {
    const Lesson& lesson = lesson_named("lost-highlight");
    Settings settings = starting_settings(lesson);
    EXPECT_THROW(set(settings, lesson, "level"), apps::UsageError);
    EXPECT_THROW(set(settings, lesson, "level=9"), apps::UsageError);
    EXPECT_THROW(set(settings, lesson, "level=x"), apps::UsageError);
    EXPECT_THROW(set(settings, lesson, "level=2.5"), apps::UsageError);
    EXPECT_THROW(set(settings, lesson, "colour=1"), apps::UsageError);
    EXPECT_THROW(set_frame(settings, lesson, 6), apps::UsageError);
    EXPECT_THROW(lesson_named("no-such"), apps::UsageError);
    set_frame(settings, lesson, 2);
    EXPECT_EQ(settings.at("level"), 2.0);
}

}  // namespace
}  // namespace scanlight::demo
