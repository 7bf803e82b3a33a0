#version 150
// The mean over each pixel's circle of confusion. Sharp neighbours do not bleed into it. Pixels are read
// without filtering, because filtering would take most of a software rasteriser's time.
uniform sampler2D seen;   // a: 1 = sharp
uniform vec2 reach;       // x: radius of the largest circle in pixels of `seen`, y: its last pixel

out vec4 colour;

const vec2 kTaps[12] = vec2[12](vec2(0.29, 0.05), vec2(-0.11, 0.30), vec2(-0.26, -0.21), vec2(0.17, -0.40),
                                vec2(0.58, 0.34), vec2(0.10, 0.66), vec2(-0.52, 0.44), vec2(-0.70, -0.10),
                                vec2(-0.34, -0.66), vec2(0.46, -0.64), vec2(0.86, -0.22), vec2(0.52, 0.80));

void main()
{
    vec2 middle = floor(gl_FragCoord.xy);
    vec4 own = texelFetch(seen, ivec2(middle), 0);
    float wide = reach.x * (1.0 - own.a);
    vec4 sum = vec4(own.rgb, 1.0) * 0.25;
    for (int i = 0; i < 12; ++i) {
        vec2 place = clamp(middle + wide * kTaps[i], vec2(0.0), vec2(reach.y));
        vec4 tap = texelFetch(seen, ivec2(place), 0);
        sum += vec4(tap.rgb, 1.0) * (1.04 - tap.a);
    }
    colour = vec4(sum.rgb / sum.a, own.a);
}
