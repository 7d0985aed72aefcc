// A shaft of 10 m along x with two arms of 2 m to either side of its end, for masses beside its axis.
// gmsh -1 -format msh22 off-centre-masses.geo -o off-centre-masses.msh
Point(1) = {0, 0, 0};
Point(2) = {10, 0, 0};
Point(3) = {10, 2, 0};
Point(4) = {10, -2, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {2, 4};
Transfinite Line {1} = 21;
Transfinite Line {2, 3} = 2;
Physical Point("clamp") = {1};
Physical Line("shaft") = {1};
Physical Line("arms") = {2, 3};
