#version 150
// The featureless cover, which shows nothing of what lies under it.
in vec3 place;
in vec2 light;

uniform vec4 plain; // rgb
uniform mat4 tips;

out vec4 colour;

void main()
{
    colour = vec4(plain.rgb * light.y * shadowOf(place, tips), 1.0);
}
