// A portal frame of one bay in the x-z plane: two columns, a girder, two tie rods that cross without
// touching. Columns and ties run upwards, the girder along x.
// gmsh -1 -format msh22 portal-frame.geo -o portal-frame.msh
span = 6;
height = 4;

Point(1) = {0, 0, 0};
Point(2) = {span, 0, 0};
Point(3) = {0, 0, height};
Point(4) = {span, 0, height};
Line(1) = {1, 3};
Line(2) = {2, 4};
Line(3) = {3, 4};
Line(4) = {1, 4};
Line(5) = {2, 3};
Transfinite Line {1, 2} = 11;
Transfinite Line {3} = 13;
Transfinite Line {4, 5} = 13;
Physical Point("feet") = {1, 2};
Physical Point("corners") = {1, 2, 3, 4};
Physical Line("columns") = {1, 2};
Physical Line("girder") = {3};
Physical Line("ties") = {4, 5};
