// A panel of 1.2 m x 0.8 m with a thicker middle field and two stiffeners along it.
// gmsh -2 -bin -format msh41 stiffened-panel.geo -o stiffened-panel.msh
length = 1.2;
width = 0.8;
h = 0.05;

// Three fields across the width: edge, middle, edge.
For row In {0:3}
  y = row < 2 ? row * 0.25 : (row == 2 ? width - 0.25 : width);
  Point(10 * row + 1) = {0, y, 0, h};
  Point(10 * row + 2) = {length, y, 0, h};
  Line(10 * row + 1) = {10 * row + 1, 10 * row + 2};
EndFor
For row In {0:2}
  Line(100 + row) = {10 * row + 1, 10 * row + 11};
  Line(200 + row) = {10 * row + 2, 10 * row + 12};
  Curve Loop(row + 1) = {10 * row + 1, 200 + row, -(10 * row + 11), -(100 + row)};
  Plane Surface(row + 1) = {row + 1};
EndFor
// The middle field is regular, the outer ones are free meshes of triangles and quadrilaterals.
Transfinite Curve {11, 21} = 25;
Transfinite Curve {101, 201} = 7;
Transfinite Surface {2};
Recombine Surface {2, 3};

Physical Curve("left edge") = {100:102};
Physical Curve("right edge") = {200:202};
Physical Curve("stiffeners") = {11, 21};
Physical Surface("thin") = {1, 3};
Physical Surface("thick") = {2};
