#pragma once

struct ImDrawData;
struct SDL_Renderer;
struct SDL_Texture;

namespace scanlight::apps::window {

/// Draws Dear ImGui's lists with any SDL renderer, the software one too. Debian's ImGui has no
/// backend for it. Rectangles and letters, which are nearly all of it, are drawn as such: in
/// software that takes a tenth of the time that triangles take.
void draw_gui(const ImDrawData& data, SDL_Renderer* renderer);

/// The letters of ImGui's fonts as a texture, which is the caller's.
SDL_Texture* font_texture(SDL_Renderer* renderer);

}  // namespace scanlight::apps::window
