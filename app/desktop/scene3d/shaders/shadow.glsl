// The share of the light that reaches a point under the tips: a round spot below each tip, wider and paler
// with the tip's height. Inserted before the fragment shaders of the field, with TOOLS defined.
float shadowOf(vec3 place, mat4 tips)
{
    float shadow = 1.0;
#if TOOLS > 0
    for (int i = 0; i < TOOLS; ++i) {
        vec3 beside = tips[i].xyz - place;
        float height = max(0.0, beside.z);
        float wide = 3.2 + 0.10 * height;
        float blob = max(0.0, 1.0 - dot(beside.xy, beside.xy) / (wide * wide));
        shadow -= tips[i].w * blob * blob * 0.62 / (1.0 + 0.02 * height) * step(-2.0, beside.z);
    }
#endif
    return max(0.25, shadow);
}
