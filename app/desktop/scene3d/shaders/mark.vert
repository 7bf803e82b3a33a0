#version 150
// Marks in the camera's picture: rings and ticks on the bladder's wall.
in vec3 vertexPosition;
in vec3 vertexNormal;
in vec2 vertexTexCoord;
in float vertexLight;

uniform mat4 mvp;

out vec2 at;

void main()
{
    at = vertexTexCoord;
    gl_Position = mvp * vec4(vertexPosition, 1.0);
}
