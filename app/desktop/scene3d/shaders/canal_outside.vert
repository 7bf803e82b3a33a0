#version 150
// The urethra in the overview. Behind the tip it lies round the rigid shaft, wherever the shaft is held, up
// to its anchored part before the neck. (The simulation's surface knows only the tip.)
in float wallX;
in float wallY;
in float wallZ;
in float wallNormalX;
in float wallNormalY;
in float wallNormalZ;
in float wallArc;  // m along the centre-line
in float wallTurn;

uniform mat4 mvp;
uniform mat4 modelView;
uniform mat3 modelViewNormal;
// x: 2c of the centre-line (1/m), y: mm of a picture of the wall along it, z: length of its straight part
// (m).
uniform vec3 bend;
uniform vec4 tip;      // xyz: m, A; w: its arc length, far outside while the canal is at rest
// xyz: direction of the shaft, A; w: m behind the tip over which the surface's own offset fades.
uniform vec4 ahead;
uniform vec4 anchored; // xy: the tip's offset along x̂ and n, m; z: arc length up to which the canal is free to move, w: of the neck

out vec3 eye;
out vec3 normal;
out vec2 spot;

/// z beyond the straight part, at arc length `s` beyond it.
float pastOf(float s)
{
    float z = s;
    for (int i = 0; i < 4; ++i) {
        float slope = bend.x * z;
        float root = sqrt(1.0 + slope * slope);
        z -= (0.5 * z * root + asinh(slope) / (2.0 * bend.x) - s) / root;
    }
    return z;
}

/// Rotates the direction `from` into `to` by the shortest rotation.
vec3 turned(vec3 v, vec3 from, vec3 to)
{
    vec3 axis = cross(from, to);
    return v + cross(axis, v) + cross(axis, cross(axis, v)) / (1.0 + dot(from, to));
}

void main()
{
    vec3 place = vec3(wallX, wallY, wallZ);
    vec3 turnedNormal = vec3(wallNormalX, wallNormalY, wallNormalZ);
    float past = pastOf(max(0.0, wallArc - bend.z));
    float z = clamp(wallArc, 0.0, bend.z) + past;
    vec3 t = normalize(vec3(0.0, bend.x * past, 1.0));
    float behind = tip.w - wallArc;
    if (behind > 0.0) {
        vec3 n = vec3(0.0, t.z, -t.y);
        float own = 0.5 + 0.5 * cos(3.14159265 * min(1.0, behind / ahead.w));
        vec3 middle = vec3(0.0, 0.5 * bend.x * past * past, z) + own * (anchored.x * vec3(1.0, 0.0, 0.0) + anchored.y * n);
        float free = 1.0 - smoothstep(anchored.z, anchored.w, wallArc);
        vec3 way = normalize(mix(t, ahead.xyz, free));
        place = mix(middle, tip.xyz - behind * ahead.xyz, free) + turned(place - middle, t, way);
        turnedNormal = turned(turnedNormal, t, way);
    }
    normal = modelViewNormal * turnedNormal;
    eye = (modelView * vec4(1000.0 * place, 1.0)).xyz;
    spot = vec2(wallTurn, wallArc * 1000.0 / bend.y);
    gl_Position = mvp * vec4(1000.0 * place, 1.0);
}
