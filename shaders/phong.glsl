// Direct light on a diffuse surface (eq. 4.6). The same formulas as scene/light/light.cpp,
// scene/material.cpp and trace/shade.cpp, in the same order; a test compares them.

const float kPi = 3.14159265358979;

struct LightArrival {
  vec3 to_light;    // unit
  vec3 irradiance;  // on a surface facing the light
};

LightArrival light_arrival(Light light, vec3 point) {
#if FEW_SUNS
  return LightArrival(light.to_light, light.intensity);
#else
  if (light.kind == kDirectionalLight) return LightArrival(light.to_light, light.intensity);
  vec3 offset = light.position - point;
  float d = max(length(offset), kMinLightDistance);
  vec3 to_light = offset / d;
  float window = 1.0;
  if (light.range > 0.0) {
    float ratio = d / light.range;
    window = clamp(1.0 - ratio * ratio * ratio * ratio, 0.0, 1.0);
  }
  if (light.kind == kSpotLight) {
    float scale = 1.0 / max(kMinConeWidth, light.cos_inner - light.cos_outer);
    float cone = clamp((dot(light.to_light, to_light) - light.cos_outer) * scale, 0.0, 1.0);
    window *= cone * cone;
  }
  return LightArrival(to_light, light.intensity * (window / (d * d)));
#endif
}

struct PhongTerms {
  vec3 albedo;
  vec3 specular;
  float exponent;
};

PhongTerms phong_terms(vec3 color, MetallicRoughness point) {
  return PhongTerms(color * (1.0 - point.metallic) * (1.0 - kDielectricF0),
                    mix(vec3(kDielectricF0), color, point.metallic), point.phong_exponent);
}

// Radiance towards `view` from one unoccluded light. cosine: N.L > 0.
vec3 phong_contribution(PhongTerms terms, vec3 normal, vec3 view, LightArrival arrival,
                        float cosine) {
  vec3 reflected = 2.0 * cosine * normal - arrival.to_light;
  float along = max(dot(reflected, view), 0.0);
  // pow(0, 0) is undefined in GLSL and 1 in C++.
  float lobe = terms.exponent == 0.0 ? 1.0 : pow(along, terms.exponent);
  vec3 brdf = terms.albedo / kPi + terms.specular * ((terms.exponent + 2.0) / (2.0 * kPi) * lobe);
  return arrival.irradiance * cosine * brdf;
}
