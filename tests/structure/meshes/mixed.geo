// A sheet with triangles on one half and quadrilaterals on the other, for the reader's test.
// for v in 22 41: gmsh -2 -format msh$v [-bin] mixed.geo -o mixed-$v-(ascii|binary).msh
Point(1) = {0, 0, 0};
Point(2) = {1, 0, 0};
Point(3) = {2, 0, 0.2};
Point(4) = {2, 1, 0.2};
Point(5) = {1, 1, 0};
Point(6) = {0, 1, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 1};
Line(7) = {2, 5};
Curve Loop(1) = {1, 7, 5, 6};
Curve Loop(2) = {2, 3, 4, -7};
Plane Surface(1) = {1};
Plane Surface(2) = {2};
Transfinite Curve {1:7} = 4;
Transfinite Surface {1, 2};
Recombine Surface {2};
Physical Point("corner") = {1};
Physical Curve("left edge") = {6};
Physical Surface("thin part") = {1};
Physical Surface("thick part") = {2};
Physical Surface("sheet") = {1, 2};
