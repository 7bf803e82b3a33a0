#version 150
// The force bar: a rectangle in the picture's own coordinates.
in vec3 vertexPosition;
in vec3 vertexNormal;
in vec2 vertexTexCoord;
in float vertexLight;

uniform vec4 spot; // left, bottom, width, height: −1..1

out vec2 at;

void main()
{
    at = vertexTexCoord;
    gl_Position = vec4(spot.xy + vertexTexCoord * spot.zw, 0.0, 1.0);
}
