#version 150
// The soft shade of what lies or hangs over the floor; a vertex says how dark.
in vec4 light;

out vec4 colour;

void main()
{
    colour = vec4(0.20, 0.02, 0.04, light.x);
}
