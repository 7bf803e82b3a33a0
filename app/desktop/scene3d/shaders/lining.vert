#version 150
// Bladder, neck and glans (mm, A).
in vec3 vertexPosition;
in vec3 vertexNormal;
in vec2 vertexTexCoord;
in float vertexLight;

uniform mat4 mvp;
uniform mat4 modelView;
uniform mat3 modelViewNormal;
uniform vec3 axis; // A: the direction of the picture's second coordinate

out vec2 spot;

void main()
{
    lightUp((modelView * vec4(vertexPosition, 1.0)).xyz, modelViewNormal * vertexNormal, modelViewNormal * axis);
    spot = vertexTexCoord;
    gl_Position = mvp * vec4(vertexPosition, 1.0);
}
