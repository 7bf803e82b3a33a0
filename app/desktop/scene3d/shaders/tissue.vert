#version 150
// The surface yields to the tips as in Dent::displaced(): one matrix column per tool, in millimetres.
in vec3 vertexPosition;
in vec3 vertexNormal;
in vec2 vertexTexCoord;
in float vertexLight;

uniform mat4 mvp;
uniform mat4 dentPlace;  // xyz: touched point, w: depth
uniform mat4 dentNormal; // xyz: outward normal, w: reach
uniform vec3 eyePosition;
uniform vec3 lamp;       // towards the overhead lamp, unit
uniform vec4 lens;       // z: strength of the vignette
uniform mat4 presses;    // xyz: pressed point, w: strength, 0..1

out vec3 place;
out vec3 normal;
out vec3 halfway;        // halfway between lamp and eye
out vec2 along;
out vec2 press;          // x: blanched, y: blood pushed aside
// x: light that reaches this point, y: soft light on it; both darker towards the picture's corners.
out vec2 light;

void main()
{
    vec3 moved = vertexPosition;
    vec3 turned = vertexNormal;
    for (int i = 0; i < 4; ++i) {
        float depth = dentPlace[i].w;
        if (depth <= 0.0)
            continue;
        vec3 n = dentNormal[i].xyz;
        float reach2 = dentNormal[i].w * dentNormal[i].w;
        vec3 r = vertexPosition - dentPlace[i].xyz;
        float rest = max(0.0, 1.0 - dot(r, r) / reach2);
        moved -= depth * rest * rest * rest * n;
        vec3 slope = -6.0 * rest * rest / reach2 * r; // gradient of rest^3
        turned = turned * (1.0 - depth * dot(n, slope)) + depth * dot(n, turned) * slope;
    }
    gl_Position = mvp * vec4(moved, 1.0);
    place = moved;
    normal = normalize(turned);
    press = vec2(0.0);
    for (int i = 0; i < 4; ++i) {
        vec3 off = presses[i].xyz - moved;
        float away = dot(off, off);
        press.x += max(0.0, 1.0 - away * 0.012) * presses[i].w;
        press.y += max(0.0, 1.0 - away * 0.0045) * presses[i].w;
    }
    press = min(press, 1.0);
    press.y *= 1.0 - press.x;
    along = vertexTexCoord / 72.0;
    // The diffuse part of the soft light is computed here, and only the wet highlight per pixel.
    vec3 toEye = normalize(eyePosition - moved);
    halfway = normalize(toEye + lamp);
    vec2 corner = gl_Position.xy / gl_Position.w;
    light.x = vertexLight * (1.0 - lens.z * dot(corner, corner));
    light.y = light.x * (0.30 + 0.40 * (0.5 + 0.5 * dot(normal, lamp)) + 0.42 * max(0.0, dot(normal, toEye)));
}
