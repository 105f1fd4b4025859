// TM of scene/tone_map.h: x / (1 + x), written so that infinity gives 1 and small x keep their
// digits (numerics B17).
float compress(float x) { return x < 1.0 ? x / (1.0 + x) : 1.0 / (1.0 + 1.0 / x); }

vec3 tone_map(vec3 scene_linear, float exposure) {
  precise vec3 x = exposure * scene_linear;
  return vec3(compress(x.r), compress(x.g), compress(x.b));
}
