#include "apps/demo/window/gui_draw.h"

#include <SDL.h>
#include <imgui.h>

#include <algorithm>
#include <span>

namespace scanlight::apps::window {

namespace {

using Corner = ImDrawVert;

/// What one command draws.
struct Batch {
    std::span<const ImDrawVert> vertices;
    std::span<const ImDrawIdx> indices;
    SDL_Texture* texture;

    const Corner& corner(std::size_t index) const { return vertices[indices[index]]; }
};

SDL_Color color_of(const Corner& corner) {
    const auto channel = [&](int shift) { return static_cast<Uint8>(corner.col >> shift & 0xffu); };
    return {channel(IM_COL32_R_SHIFT), channel(IM_COL32_G_SHIFT), channel(IM_COL32_B_SHIFT),
            channel(IM_COL32_A_SHIFT)};
}

// ---- rectangles

/// Whether six indices from `first` on are those that ImGui gives a rectangle: 0 1 2, 0 2 3.
bool has_form_of_quad(const Batch& batch, std::size_t first) {
    if (first + 6 > batch.indices.size()) return false;
    const auto index = batch.indices.subspan(first, 6);
    const auto a = index[0];
    return index[1] == a + 1 && index[2] == a + 2 && index[3] == a && index[4] == a + 2 &&
           index[5] == a + 3;
}

bool is_rectangle(const Corner& a, const Corner& b, const Corner& c, const Corner& d) {
    return a.pos.y == b.pos.y && b.pos.x == c.pos.x && c.pos.y == d.pos.y && d.pos.x == a.pos.x &&
           a.col == b.col && a.col == c.col && a.col == d.col;
}

SDL_FRect place_of(const Corner& a, const Corner& c) {
    return {a.pos.x, a.pos.y, c.pos.x - a.pos.x, c.pos.y - a.pos.y};
}

SDL_Rect texels_of(const Corner& a, const Corner& c, SDL_Texture* texture) {
    int width = 0;
    int height = 0;
    SDL_QueryTexture(texture, nullptr, nullptr, &width, &height);
    const auto texel = [](float share, int size) {
        return static_cast<int>(share * static_cast<float>(size) + 0.5f);
    };
    const int x = texel(a.uv.x, width);
    const int y = texel(a.uv.y, height);
    return {x, y, texel(c.uv.x, width) - x, texel(c.uv.y, height) - y};
}

void fill(const Corner& a, const Corner& c, SDL_Renderer* renderer) {
    const SDL_Color color = color_of(a);
    const SDL_FRect place = place_of(a, c);
    SDL_SetRenderDrawColor(renderer, color.r, color.g, color.b, color.a);
    SDL_RenderFillRectF(renderer, &place);
}

void copy(const Corner& a, const Corner& c, SDL_Texture* texture, SDL_Renderer* renderer) {
    const SDL_Color color = color_of(a);
    const SDL_FRect place = place_of(a, c);
    const SDL_Rect texels = texels_of(a, c, texture);
    SDL_SetTextureColorMod(texture, color.r, color.g, color.b);
    SDL_SetTextureAlphaMod(texture, color.a);
    SDL_RenderCopyF(renderer, texture, &texels, &place);
}

/// Whether a rectangle of one colour begins at this index.
bool begins_rectangle(const Batch& batch, std::size_t first) {
    return has_form_of_quad(batch, first) &&
           is_rectangle(batch.corner(first), batch.corner(first + 1), batch.corner(first + 2),
                        batch.corner(first + 5));
}

void draw_rectangle(const Batch& batch, std::size_t first, SDL_Renderer* renderer) {
    const Corner& a = batch.corner(first);
    const Corner& c = batch.corner(first + 2);
    const bool is_plain = a.uv.x == c.uv.x && a.uv.y == c.uv.y;
    is_plain ? fill(a, c, renderer) : copy(a, c, batch.texture, renderer);
}

// ---- triangles

void draw_triangles(const Batch& batch, std::size_t first, std::size_t end,
                    SDL_Renderer* renderer) {
    if (first == end) return;
    SDL_SetTextureColorMod(batch.texture, 255, 255, 255);
    SDL_SetTextureAlphaMod(batch.texture, 255);
    const Corner* v = batch.vertices.data();
    SDL_RenderGeometryRaw(renderer, batch.texture, &v->pos.x, sizeof(Corner),
                          reinterpret_cast<const SDL_Color*>(&v->col), sizeof(Corner), &v->uv.x,
                          sizeof(Corner), static_cast<int>(batch.vertices.size()),
                          batch.indices.data() + first, static_cast<int>(end - first),
                          sizeof(ImDrawIdx));
}

/// In their order: rectangles one by one, the triangles between them together.
void draw_batch(const Batch& batch, SDL_Renderer* renderer) {
    std::size_t waiting = 0;
    for (std::size_t at = 0; at < batch.indices.size();) {
        if (!begins_rectangle(batch, at)) {
            at += 3;
            continue;
        }
        draw_triangles(batch, waiting, at, renderer);
        draw_rectangle(batch, at, renderer);
        waiting = at += 6;
    }
    draw_triangles(batch, waiting, batch.indices.size(), renderer);
}

SDL_Rect clip_of(const ImDrawCmd& command) {
    const auto& r = command.ClipRect;
    const auto whole = [](float x) { return static_cast<int>(x); };
    return {whole(r.x), whole(r.y), whole(r.z) - whole(r.x), whole(r.w) - whole(r.y)};
}

void draw_list(const ImDrawList& list, SDL_Renderer* renderer) {
    for (const ImDrawCmd& command : list.CmdBuffer) {
        const SDL_Rect clip = clip_of(command);
        if (clip.w <= 0 || clip.h <= 0) continue;
        SDL_RenderSetClipRect(renderer, &clip);
        const std::span vertices(list.VtxBuffer.Data,
                                 static_cast<std::size_t>(list.VtxBuffer.Size));
        const std::span indices(list.IdxBuffer.Data, static_cast<std::size_t>(list.IdxBuffer.Size));
        draw_batch({vertices.subspan(command.VtxOffset),
                    indices.subspan(command.IdxOffset, command.ElemCount),
                    static_cast<SDL_Texture*>(command.GetTexID())},
                   renderer);
    }
}

}  // namespace

void draw_gui(const ImDrawData& data, SDL_Renderer* renderer) {
    SDL_SetRenderDrawBlendMode(renderer, SDL_BLENDMODE_BLEND);
    for (int i = 0; i < data.CmdListsCount; ++i)
        draw_list(*data.CmdLists[i], renderer);
    SDL_RenderSetClipRect(renderer, nullptr);
}

SDL_Texture* font_texture(SDL_Renderer* renderer) {
    unsigned char* texels = nullptr;
    int width = 0;
    int height = 0;
    ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&texels, &width, &height);
    SDL_Texture* texture = SDL_CreateTexture(renderer, SDL_PIXELFORMAT_ABGR8888,
                                             SDL_TEXTUREACCESS_STATIC, width, height);
    SDL_UpdateTexture(texture, nullptr, texels, 4 * width);
    SDL_SetTextureBlendMode(texture, SDL_BLENDMODE_BLEND);
    ImGui::GetIO().Fonts->SetTexID(texture);
    return texture;
}

}  // namespace scanlight::apps::window
