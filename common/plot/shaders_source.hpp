#pragma once
/// GLSL 3.30 sources. Every vertex shader begins with `prelude_glsl`.
namespace plot::source {

// Row 0 of a target is the top of the picture, so that y needs no flip here nor when the pixels are read.
// Quads are instances: the corner (-1 or 1 each way) comes from the number of the vertex.
inline constexpr const char* prelude = R"(#version 330 core
uniform vec2 target_size;
vec4 place(vec2 pixel) { return vec4(2.0 * pixel / target_size - 1.0, 0.0, 1.0); }
vec2 corner() { return vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0; }
)";

inline constexpr const char* capsule_vertex = R"(
uniform float half_width;
layout(location = 0) in vec4 ends;
out vec2 local;            // along and across the segment, from its first end
flat out vec2 tangent;
flat out float length_;
void main() {
    vec2 way = ends.zw - ends.xy;
    length_ = length(way);
    tangent = length_ > 0.0 ? way / length_ : vec2(1.0, 0.0);
    float reach = half_width + 0.75;  // half a pixel's diagonal and a little
    local = corner() * reach;
    if (local.x > 0.0) local.x += length_;
    gl_Position = place(ends.xy + tangent * local.x + vec2(-tangent.y, tangent.x) * local.y);
}
)";

// A pixel is a unit square: seen along a direction its area is spread as a trapezoid, whose integral gives
// the exact part of the square that lies on one side of a straight edge. A stroke is what lies between two
// edges.
inline constexpr const char* capsule_fragment = R"(#version 330 core
uniform float half_width;
in vec2 local;
flat in vec2 tangent;
flat in float length_;
out float coverage;
float below(float distance, float wide, float narrow) {
    float u = min(abs(distance), 0.5 * (wide + narrow));
    float k = max(u - 0.5 * (wide - narrow), 0.0);
    return 0.5 + sign(distance) * (u - k * k / (2.0 * narrow)) / wide;
}
void main() {
    vec2 off = vec2(local.x - clamp(local.x, 0.0, length_), local.y);
    float distance = length(off);
    vec2 normal = distance > 1e-6 ? off / distance : vec2(0.0, 1.0);
    vec2 box = abs(vec2(tangent.x * normal.x - tangent.y * normal.y,
                        tangent.y * normal.x + tangent.x * normal.y));
    float wide = max(box.x, box.y);
    float narrow = max(min(box.x, box.y), 1e-3);
    coverage = below(half_width - distance, wide, narrow) + below(half_width + distance, wide, narrow) - 1.0;
}
)";

inline constexpr const char* box_vertex = R"(
layout(location = 0) in vec4 box;  // left, top, right, bottom
void main() { gl_Position = place(mix(box.xy, box.zw, 0.5 * corner() + 0.5)); }
)";

inline constexpr const char* mask_fragment = R"(#version 330 core
uniform sampler2D image;
uniform vec4 colour;
out vec4 result;
void main() { result = colour * texelFetch(image, ivec2(gl_FragCoord.xy), 0).r; }
)";

inline constexpr const char* flat_fragment = R"(#version 330 core
uniform vec4 colour;
out vec4 result;
void main() { result = colour; }
)";

inline constexpr const char* triangle_vertex = R"(
uniform vec2 tile_origin;
uniform float magnification;
layout(location = 0) in vec2 position;
layout(location = 1) in vec4 colour;
out vec4 shade;
void main() {
    shade = vec4(colour.rgb * colour.a, colour.a);
    gl_Position = place((position - tile_origin) * magnification);
}
)";

inline constexpr const char* triangle_fragment = R"(#version 330 core
in vec4 shade;
out vec4 result;
void main() { result = shade; }
)";

// Four bilinear samples, each between four texels, are the mean of 4x4.
inline constexpr const char* resolve_fragment = R"(#version 330 core
uniform sampler2D image;
uniform vec2 tile_origin;
uniform float tile_texels;
out vec4 result;
void main() {
    vec2 first = (gl_FragCoord.xy - 0.5 - tile_origin) * 4.0;
    vec4 sum = texture(image, (first + vec2(1.0, 1.0)) / tile_texels) +
               texture(image, (first + vec2(3.0, 1.0)) / tile_texels) +
               texture(image, (first + vec2(1.0, 3.0)) / tile_texels) +
               texture(image, (first + vec2(3.0, 3.0)) / tile_texels);
    result = 0.25 * sum;
}
)";

inline constexpr const char* disc_vertex = R"(
uniform float radius;
uniform float strength;
layout(location = 0) in vec2 centre;
layout(location = 1) in vec4 colour;
out vec2 local;
flat out vec4 shade;
void main() {
    shade = vec4(colour.rgb * colour.a, colour.a) * strength;
    local = corner() * (radius + 0.5);
    gl_Position = place(centre + local);
}
)";

inline constexpr const char* disc_fragment = R"(#version 330 core
uniform float radius;
in vec2 local;
flat in vec4 shade;
out vec4 result;
void main() { result = shade * clamp(radius + 0.5 - length(local), 0.0, 1.0); }
)";

inline constexpr const char* marker_vertex = R"(
uniform float reach;
layout(location = 0) in vec2 centre;
out vec2 local;
void main() {
    local = corner() * reach;
    gl_Position = place(centre + local);
}
)";

// `shape` is the number of plot::Marker. Distances are negative inside; where sides meet, the larger one
// counts, which gives the edges mitred corners.
inline constexpr const char* marker_fragment = R"(#version 330 core
uniform int shape;
uniform float size;
uniform float edge_width;
uniform vec4 fill;
uniform vec4 edge;
in vec2 local;
out vec4 result;
float box(vec2 p, vec2 half_size) {
    vec2 q = abs(p) - half_size;
    return max(q.x, q.y);
}
float triangle(vec2 p, float inner) { return max(abs(p.x) * 0.8660254 - p.y * 0.5, p.y) - inner; }
float arms(vec2 p) {
    vec2 arm = vec2(0.6 * size, 0.5 * edge_width);
    return min(box(p, arm), box(p, arm.yx));
}
float outline(vec2 p) {
    vec2 turned = vec2(p.x + p.y, p.x - p.y) * 0.70710678;
    if (shape == 1) return length(p) - 0.5 * size;
    if (shape == 2) return box(p, vec2(0.44311346 * size));
    if (shape == 3) return box(turned, vec2(0.44311346 * size));
    if (shape == 4) return triangle(p, 0.38877 * size);
    if (shape == 5) return triangle(vec2(p.x, -p.y), 0.38877 * size);
    return shape == 6 ? arms(p) : arms(turned);
}
float inside(float distance) { return clamp(0.5 - distance, 0.0, 1.0); }
void main() {
    float distance = outline(local);
    if (shape >= 6) {
        result = edge * inside(distance);
        return;
    }
    float inner = inside(distance + 0.5 * edge_width);
    result = fill * inner + edge * (inside(distance - 0.5 * edge_width) - inner);
}
)";

inline constexpr const char* glyph_vertex = R"(
layout(location = 0) in vec4 target;   // left, top, width, height
layout(location = 1) in vec2 texel;
layout(location = 2) in vec4 colour;
out vec2 at;
flat out vec4 shade;
void main() {
    vec2 offset = (0.5 * corner() + 0.5) * target.zw;
    shade = vec4(colour.rgb * colour.a, colour.a);
    at = texel + offset;
    gl_Position = place(target.xy + offset);
}
)";

inline constexpr const char* glyph_fragment = R"(#version 330 core
uniform sampler2D image;
in vec2 at;
flat in vec4 shade;
out vec4 result;
void main() { result = shade * texelFetch(image, ivec2(at), 0).r; }
)";

}  // namespace plot::source
