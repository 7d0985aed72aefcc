// A beam of 0.5 m that is folded back on itself: both halves lie in one place and share their far end.
// gmsh -1 -format msh22 folded-beam.geo -o folded-beam.msh
Point(1) = {0, 0, 0};
Point(2) = {0.5, 0, 0};
Point(3) = {0, 0, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Transfinite Line {1, 2} = 21;
Physical Point("clamp") = {1};
Physical Line("beam") = {1, 2};
