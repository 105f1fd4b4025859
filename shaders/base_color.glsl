// Base colour of a surface point: material times texture, as scene/texture_lookup.h has it.
//
// Texels are fetched as bytes, decoded by the table that the CPU uses and mixed here, because the
// drivers' samplers mix with 8-bit weights (llvmpipe, most GPUs) or decode by an approximation, and
// the tracer would then see other colours than the rasteriser.

// TEXTURED: this program is for surfaces with a texture.
#if TEXTURED
layout(binding = 0) uniform usampler2D base_color_texture;

float decode_srgb(uint byte) { return srgb_table[byte >> 2][byte & 3u]; }

int wrap_texel(int i, int size, uint wrap) {  // 0 repeat, 1 mirror, 2 clamp
  if (wrap == 2u) return clamp(i, 0, size - 1);
  int period = wrap == 0u ? size : 2 * size;
  // The remainder of a negative number is undefined in GLSL.
  int m = i >= 0 ? i % period : period - 1 - (-1 - i) % period;
  return m < size ? m : period - 1 - m;
}

vec4 linear_texel(int x, int y) {
  uvec4 texel = texelFetch(base_color_texture, ivec2(x, y), 0);
  return vec4(decode_srgb(texel.r), decode_srgb(texel.g), decode_srgb(texel.b),
              float(texel.a) / 255.0);
}

vec4 sample_base_color(vec2 uv, uvec2 wrap) {
  ivec2 size = textureSize(base_color_texture, 0);
  vec2 p = uv * vec2(size) - 0.5;
  if (!(abs(p.x) < 1e9) || !(abs(p.y) < 1e9)) return vec4(0.0, 0.0, 0.0, 1.0);
  vec2 whole = floor(p);
  vec2 f = p - whole;
  int x0 = wrap_texel(int(whole.x), size.x, wrap.x);
  int x1 = wrap_texel(int(whole.x) + 1, size.x, wrap.x);
  int y0 = wrap_texel(int(whole.y), size.y, wrap.y);
  int y1 = wrap_texel(int(whole.y) + 1, size.y, wrap.y);
  return mix(mix(linear_texel(x0, y0), linear_texel(x1, y0), f.x),
             mix(linear_texel(x0, y1), linear_texel(x1, y1), f.x), f.y);
}
#endif

vec4 base_color(vec2 uv) {
#if TEXTURED
  return material.base_color * sample_base_color(uv, material.wrap);
#else
  return material.base_color;
#endif
}

// Alpha masks: where nothing is. Without a texture a surface is there as a whole or is not drawn at
// all, and the driver may test depth before it shades.
bool is_cut_out(vec4 color) {
#if TEXTURED
  return color.a < material.alpha_cutoff;
#else
  return false;
#endif
}
