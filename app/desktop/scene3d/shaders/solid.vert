#version 150
in vec3 vertexPosition;
in vec3 vertexNormal;
in vec2 vertexTexCoord;
in float vertexLight;

uniform mat4 mvp;
uniform mat4 modelMatrix;
uniform mat3 modelNormalMatrix;

out vec3 place;
out vec3 normal;
out float steel;

void main()
{
    place = (modelMatrix * vec4(vertexPosition, 1.0)).xyz;
    normal = modelNormalMatrix * vertexNormal;
    steel = vertexTexCoord.x;
    gl_Position = mvp * vec4(vertexPosition, 1.0);
}
