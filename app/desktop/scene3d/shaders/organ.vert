#version 150
// Soft organs, tube and ovaries. The light is the same as on the tissue of the field, computed per vertex
// except for the wet highlight.
in vec3 vertexPosition;
in vec3 vertexNormal;
in vec2 vertexTexCoord; // mm along the surface
in float vertexLight;   // 0..1 lit; above 1 also blanched; below 0 an open wound, lit

uniform mat4 mvp;
uniform mat4 modelMatrix;
uniform mat3 modelNormalMatrix;
uniform vec3 eyePosition;
uniform vec3 lamp;
uniform vec4 lens; // z: strength of the vignette

out vec3 normal;
out vec3 halfway;
out vec2 along;
// x: light that reaches this point, y: soft light, z: blanched; below 0 bloody, w: how much it faces the eye.
out vec4 light;

void main()
{
    vec3 place = (modelMatrix * vec4(vertexPosition, 1.0)).xyz;
    normal = normalize(modelNormalMatrix * vertexNormal);
    vec3 toEye = normalize(eyePosition - place);
    halfway = normalize(toEye + lamp);
    along = vertexTexCoord / 46.0;
    gl_Position = mvp * vec4(vertexPosition, 1.0);
    vec2 corner = clamp(gl_Position.xy / gl_Position.w, -1.3, 1.3);
    light.x = min(1.0, abs(vertexLight)) * (1.0 - lens.z * dot(corner, corner));
    light.w = max(0.0, dot(normal, toEye));
    light.y = light.x * (0.26 + 0.40 * (0.5 + 0.5 * dot(normal, lamp)) + 0.46 * light.w);
    light.z = vertexLight > 1.0 ? vertexLight - 1.0 : min(0.0, vertexLight);
}
