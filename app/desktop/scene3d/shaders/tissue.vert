#version 150
// The surface gives way under the tips as Dent::displaced() says: one column of each matrix a tool, millimetres.
in vec3 vertexPosition;
in vec3 vertexNormal;
in vec2 vertexTexCoord;
in float vertexLight;

uniform mat4 mvp;
uniform mat4 dentPlace;  // xyz: touched point, w: depth
uniform mat4 dentNormal; // xyz: outward normal, w: reach

out vec3 place;
out vec3 normal;
out vec2 along;
out float light;

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
    place = moved;
    normal = normalize(turned);
    along = vertexTexCoord / 72.0;
    light = vertexLight;
    gl_Position = mvp * vec4(moved, 1.0);
}
