// A frame of one bay and three storeys in the x-z plane; its right-hand joints are at x = 0.
// gmsh -1 -format msh41 frame-three-storeys.geo -o frame-three-storeys.msh
bay = 6;
storey = 3.2;
storeys = 3;
right = 0;
elements = 6;

For floor In {0:storeys}
  Point(10 * floor + 1) = {right - bay, 0, floor * storey};
  Point(10 * floor + 2) = {right, 0, floor * storey};
EndFor
For floor In {1:storeys}
  Line(10 * floor + 1) = {10 * floor - 9, 10 * floor + 1};
  Line(10 * floor + 2) = {10 * floor - 8, 10 * floor + 2};
  Line(10 * floor + 3) = {10 * floor + 1, 10 * floor + 2};
  Transfinite Line {10 * floor + 1, 10 * floor + 2, 10 * floor + 3} = elements + 1;
EndFor
Physical Point("feet") = {1, 2};
Physical Point("right joints") = {12, 22, 32};
Physical Line("frame") = {11:13, 21:23, 31:33};
