#version 150
// The soft shadow of objects that lie on the floor or hang over it; each vertex gives the darkness.
in vec4 light;

out vec4 colour;

void main()
{
    colour = vec4(0.20, 0.02, 0.04, light.x);
}
