#version 150
// The picture with depth of field: sharp and blurred put together by the circle of confusion.
in vec2 at;

uniform sampler2D seen;
uniform sampler2D blurred;
uniform vec4 corner; // xy: of the picture in the window, pixels from below

out vec4 colour;

void main()
{
    vec4 sharp = texelFetch(seen, ivec2(gl_FragCoord.xy - corner.xy), 0);
    vec4 soft = texture(blurred, at);
    float share = clamp((1.0 - sharp.a) * 7.0 - 0.4, 0.0, 1.0);
    colour = vec4(mix(sharp.rgb, soft.rgb, share), 1.0);
}
