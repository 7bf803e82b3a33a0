#version 150
// Flat shapes in the picture's own coordinates, −1..1.
in vec3 vertexPosition;
in vec3 vertexNormal;
in vec2 vertexTexCoord;
in float vertexLight;

uniform mat4 modelMatrix;

out vec2 at;

void main()
{
    at = vertexTexCoord;
    gl_Position = vec4((modelMatrix * vec4(vertexPosition, 1.0)).xyz, 1.0);
}
