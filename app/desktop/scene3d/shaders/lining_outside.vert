#version 150
// Bladder, neck and glans in the overview (mm, A).
in vec3 vertexPosition;
in vec3 vertexNormal;
in vec2 vertexTexCoord;
in float vertexLight;

uniform mat4 mvp;
uniform mat4 modelView;
uniform mat3 modelViewNormal;

out vec3 eye;
out vec3 normal;
out vec2 spot;

void main()
{
    normal = modelViewNormal * vertexNormal;
    eye = (modelView * vec4(vertexPosition, 1.0)).xyz;
    spot = vertexTexCoord;
    gl_Position = mvp * vec4(vertexPosition, 1.0);
}
