#version 150
// Cloth fills most of the picture, so its light is computed per vertex and not per pixel.
in vec3 vertexPosition;
in vec3 vertexNormal;
in vec2 vertexTexCoord;
in float vertexLight;

uniform mat4 mvp;
uniform mat4 modelMatrix;
uniform vec3 eyePosition;
uniform vec3 lamp;
uniform vec3 cloth;
uniform vec4 lens;       // z: strength of the vignette
uniform float outlined;

out vec3 shade;

void main()
{
    vec3 place = (modelMatrix * vec4(vertexPosition, 1.0)).xyz;
    vec3 toEye = normalize(eyePosition - place);
    float head = max(0.0, dot(vertexNormal, toEye));
    float above = 0.5 + 0.5 * dot(vertexNormal, lamp);
    float lit = vertexLight * (0.34 + 0.36 * above + 0.34 * head);
    gl_Position = mvp * vec4(vertexPosition, 1.0);
    vec2 off = clamp(gl_Position.xy / gl_Position.w, -1.3, 1.3);
    shade = cloth * mix(lit, 0.96, 0.8 * outlined) * (1.0 - lens.z * dot(off, off));
}
