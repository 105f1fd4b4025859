// Trilinear look-ups, equal to scene/texture_lookup.cpp.
//
// Texels are fetched as bytes, decoded by the CPU's table and interpolated here. Drivers' samplers
// interpolate with 8-bit weights (llvmpipe, most GPUs) or decode approximately, so tracer and
// rasteriser would get different colors. The level of detail comes from ray cones, as in the
// tracer, and not from the driver's derivatives.

float decode_texel(uint byte, bool is_color) {
  return is_color ? srgb_table[byte >> 2][byte & 3u] : float(byte) / 255.0;
}

int wrap_texel(int i, int size, uint wrap) {
  if (wrap == kWrapClamp) return clamp(i, 0, size - 1);
  int period = wrap == kWrapRepeat ? size : 2 * size;
  // The remainder of a negative number is undefined in GLSL.
  int m = i >= 0 ? i % period : period - 1 - (-1 - i) % period;
  return m < size ? m : period - 1 - m;
}

vec4 decoded_texel(usampler2D map, ivec2 at, bool is_color) {
  uvec4 texel = texelFetch(map, at, 0);
  return vec4(decode_texel(texel.r, is_color), decode_texel(texel.g, is_color),
              decode_texel(texel.b, is_color), float(texel.a) / 255.0);
}

// Rows of the levels 1 to `last`, of heights max(h / 2^k, 1). Legendre: the sum of floor(h / 2^k)
// over all k >= 1 is h minus its number of 1 bits. Not a loop, because llvmpipe's compiler takes
// far too long with one in every look-up.
int rows_down_to(int last, int h) {
  int rest = h >> last;
  return h - bitCount(h) - (rest - bitCount(rest)) + max(last - findMSB(h), 0);
}

// Samples one level of the atlas: the full size at the left, the others below each other at its
// right.
vec4 sample_level(usampler2D map, ivec2 full, vec2 uv, uvec2 wrap, int level, bool is_color) {
  ivec2 at = level == 0 ? ivec2(0) : ivec2(full.x, rows_down_to(level - 1, full.y));
  ivec2 size = max(full >> level, 1);
  vec2 p = uv * vec2(size) - 0.5;
  if (!(abs(p.x) < kMaxTexelPlace) || !(abs(p.y) < kMaxTexelPlace)) return vec4(0.0, 0.0, 0.0, 1.0);
  vec2 whole = floor(p);
  vec2 f = p - whole;
  int x0 = at.x + wrap_texel(int(whole.x), size.x, wrap.x);
  int x1 = at.x + wrap_texel(int(whole.x) + 1, size.x, wrap.x);
  int y0 = at.y + wrap_texel(int(whole.y), size.y, wrap.y);
  int y1 = at.y + wrap_texel(int(whole.y) + 1, size.y, wrap.y);
  return mix(mix(decoded_texel(map, ivec2(x0, y0), is_color),
                 decoded_texel(map, ivec2(x1, y0), is_color), f.x),
             mix(decoded_texel(map, ivec2(x0, y1), is_color),
                 decoded_texel(map, ivec2(x1, y1), is_color), f.x), f.y);
}

// full: size of level 0. footprint: area of the sample in uv.
vec4 sample_map(usampler2D map, ivec2 full, vec2 uv, uvec2 wrap, float footprint, bool is_color) {
  bool has_mips = textureSize(map, 0).x > full.x;
  float texels = footprint * (float(full.x) * float(full.y));
  if (!(texels > 1.0) || !has_mips) return sample_level(map, full, uv, wrap, 0, is_color);
  int coarsest = findMSB(max(full.x, full.y));
  float lod = min(0.5 * log2(texels), float(coarsest));
  int level = int(floor(lod));
  vec4 fine = sample_level(map, full, uv, wrap, level, is_color);
  if (level == coarsest) return fine;
  return mix(fine, sample_level(map, full, uv, wrap, level + 1, is_color), lod - float(level));
}
