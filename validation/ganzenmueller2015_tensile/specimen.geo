// Dog-bone tensile specimen in 8-node hexahedra, finer in the middle. Lengths in mm. Needs Gmsh (made with 4.8.4):
//   gmsh -3 specimen.geo -format msh22 -o specimen.msh                      1800 elements
//   gmsh -3 specimen.geo -setnumber n 2 -format msh22 -o /tmp/fine.msh      14400 elements
DefineConstant[ n = 1 ];     // elements along each edge, relative to the specimen of the case

radius = 50;                 // of the flanks, which are parallel to x at x = 0
waist = 7.5;                 // half width at x = 0
grip = 12.5;                 // half width of the ends
half_length = 50;
held = 45;                   // the specimen is held where |x| >= 45
thickness = 10;              // z from 0 to 10
shoulder = Sqrt(radius^2 - (radius + waist - grip)^2);   // 21.794: where the arc meets the straight edge

// Along x, each half: 13 + 10 + 2 elements, each longer than the one before by the same ratio; the last about twice the first.
along_arc = 13*n;
along_grip = 10*n;
along_held = 2*n;
ratio = 2^(1/(25*n - 1));
across = 9*n;
through = 4*n;

// Sections from left to right: x and half width.
x[] = {-half_length, -held, -shoulder, 0, shoulder, held, half_length};
w[] = {grip, grip, grip, waist, grip, grip, grip};
count[] = {along_held, along_grip, along_arc, along_arc, along_grip, along_held};

For i In {0:6}
  Point(1 + i) = {x[i], -w[i], 0};
  Point(11 + i) = {x[i], w[i], 0};
  Line(1 + i) = {1 + i, 11 + i};
  Transfinite Curve {1 + i} = across + 1;
EndFor
Point(21) = {0, -waist - radius, 0};
Point(22) = {0, waist + radius, 0};

For i In {0:5}
  For side In {0:1}
    curve = 11 + 10*side + i;
    a = 1 + 10*side + i;
    If (i == 2 || i == 3)
      Circle(curve) = {a, 21 + side, a + 1};
    Else
      Line(curve) = {a, a + 1};
    EndIf
    Transfinite Curve {curve} = count[i] + 1 Using Progression (i < 3 ? 1/ratio : ratio);
  EndFor
  Curve Loop(1 + i) = {11 + i, 2 + i, -(21 + i), -(1 + i)};
  Plane Surface(1 + i) = {1 + i};
  Transfinite Surface {1 + i} = {1 + i, 2 + i, 12 + i, 11 + i};
  Recombine Surface {1 + i};
EndFor

volumes[] = {};
For i In {0:5}
  made[] = Extrude {0, 0, thickness} { Surface{1 + i}; Layers{through}; Recombine; };
  volumes[] += made[1];
EndFor
Physical Volume("specimen") = volumes[];
