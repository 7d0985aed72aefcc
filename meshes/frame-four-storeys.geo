// A frame of one bay and four storeys in the x-z plane; its left-hand joints are at x = 0.1 m.
// gmsh -1 -format msh41 frame-four-storeys.geo -o frame-four-storeys.msh
bay = 4;
storey = 3.2;
storeys = 4;
left = 0.1;
elements = 6;

For floor In {0:storeys}
  Point(10 * floor + 1) = {left, 0, floor * storey};
  Point(10 * floor + 2) = {left + bay, 0, floor * storey};
EndFor
For floor In {1:storeys}
  Line(10 * floor + 1) = {10 * floor - 9, 10 * floor + 1};
  Line(10 * floor + 2) = {10 * floor - 8, 10 * floor + 2};
  Line(10 * floor + 3) = {10 * floor + 1, 10 * floor + 2};
  Transfinite Line {10 * floor + 1, 10 * floor + 2, 10 * floor + 3} = elements + 1;
EndFor
Physical Point("feet") = {1, 2};
Physical Point("left joints") = {11, 21, 31, 41};
Physical Line("frame") = {11:13, 21:23, 31:33, 41:43};
