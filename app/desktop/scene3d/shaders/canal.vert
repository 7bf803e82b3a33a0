#version 150
// The urethra. Positions (m, A) and normals come from the simulation's surface, one buffer per component.
in float wallX;
in float wallY;
in float wallZ;
in float wallNormalX;
in float wallNormalY;
in float wallNormalZ;
in float wallArc;  // m along the centre-line
in float wallTurn; // turns round the centre-line

uniform mat4 mvp;
uniform mat4 modelView;
uniform mat3 modelViewNormal;
// x: 2c of the centre-line (1/m), y: mm of a picture of the wall along it, z: length of its straight part
// (m).
uniform vec3 bend;

out vec2 spot;

void main()
{
    vec3 place = 1000.0 * vec3(wallX, wallY, wallZ);
    vec3 axis = modelViewNormal * vec3(0.0, bend.x * max(0.0, wallZ - bend.z), 1.0);
    lightUp((modelView * vec4(place, 1.0)).xyz, modelViewNormal * vec3(wallNormalX, wallNormalY, wallNormalZ), axis);
    spot = vec2(wallTurn, wallArc * 1000.0 / bend.y);
    gl_Position = mvp * vec4(place, 1.0);
}
