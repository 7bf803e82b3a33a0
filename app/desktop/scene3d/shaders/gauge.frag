#version 150
in vec2 at;

uniform sampler2D face;  // frame, scale and text as painted, not premultiplied
uniform vec4 column;     // left, bottom, width, height of the bar's hollow, 0..1
uniform vec4 fill;       // rgb, a: filled share
uniform vec3 hollow;     // the empty bar
uniform float over;      // 1: striped, because the force is over the limit
uniform vec2 size_px;

out vec4 colour;

void main()
{
    vec4 drawn = texture(face, vec2(at.x, 1.0 - at.y));
    drawn.rgb *= drawn.a;
    vec2 inside = (at - column.xy) / column.zw;
    float within = step(0.0, inside.x) * step(inside.x, 1.0) * step(0.0, inside.y) * step(inside.y, 1.0);
    float stripe = step(0.62, fract((at.x * size_px.x + at.y * size_px.y) / 11.0));
    vec3 liquid = mix(fill.rgb, mix(fill.rgb, vec3(1.0), 0.65), stripe * over);
    vec3 under = mix(hollow, liquid, step(inside.y, fill.a));
    // Frame and scale lie over the filling.
    colour.rgb = drawn.rgb + (1.0 - drawn.a) * under * within;
    colour.a = drawn.a + (1.0 - drawn.a) * within;
}
