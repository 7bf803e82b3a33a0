#version 150
// A painted picture, not premultiplied.
in vec2 at;

uniform sampler2D face;

out vec4 colour;

void main()
{
    vec4 drawn = texture(face, vec2(at.x, 1.0 - at.y));
    colour = vec4(drawn.rgb * drawn.a, drawn.a);
}
