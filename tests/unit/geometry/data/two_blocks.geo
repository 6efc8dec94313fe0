// Two skewed blocks side by side, 2 x 1 x 1.5 in all: volume 3, the left 1.2, the right 1.8.
// Made into meshes by validation/meshes/make_meshes.py; hexahedra = 1 gives hexahedra, 0 tetrahedra.
DefineConstant[ hexahedra = 0 ];
Mesh.RecombinationAlgorithm = 2;
size = hexahedra ? 0.9 : 0.7;
Point(1) = {0, 0, 0, size};
Point(2) = {0.6, 0, 0, size};
Point(3) = {2, 0, 0, size};
Point(4) = {2, 1, 0, size};
Point(5) = {1, 1, 0, size};
Point(6) = {0, 1, 0, size};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 1};
Line(7) = {2, 5};
Curve Loop(1) = {1, 7, 5, 6};
Plane Surface(1) = {1};
Curve Loop(2) = {2, 3, 4, -7};
Plane Surface(2) = {2};
If (hexahedra)
  Recombine Surface {1, 2};
  left[] = Extrude {0.3, 0.2, 1.5} { Surface{1}; Layers{2}; Recombine; };
  right[] = Extrude {0.3, 0.2, 1.5} { Surface{2}; Layers{2}; Recombine; };
Else
  left[] = Extrude {0.3, 0.2, 1.5} { Surface{1}; };
  right[] = Extrude {0.3, 0.2, 1.5} { Surface{2}; };
EndIf
Physical Volume("left") = {left[1]};
Physical Volume("right") = {right[1]};
Physical Surface("foot") = {1, 2};
