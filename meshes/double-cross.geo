// NAFEMS FV2: eight arms of 5 m from one joint, pinned at their outer ends.
// gmsh -1 -format msh41 double-cross.geo -o double-cross.msh
length = 5;
elements = 20;

Point(1) = {0, 0, 0};
For arm In {0:7}
  angle = arm * Pi / 4;
  Point(2 + arm) = {length * Cos(angle), length * Sin(angle), 0};
  Line(1 + arm) = {1, 2 + arm};
  Transfinite Line {1 + arm} = elements + 1;
EndFor
Physical Point("joint") = {1};
Physical Point("ends") = {2:9};
Physical Line("arms") = {1:8};
