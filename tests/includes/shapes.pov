// Bodies of shapes.inc beside one another, and the extents of some.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "shapes.inc"
#declare Columns = 8;
#declare Rows = 6;
camera { orthographic location <Columns * 1.5, -Rows * 1.5, -50> direction z right 3 * Columns * x up 3 * Rows * y }
light_source { <-40, 50, -60> rgb 0.9 }
background { rgb <0.3, 0.4, 0.5> }
#declare N = 0;
#macro Next() pigment { rgb <0.8, 0.6, 0.4> } rotate <-30, 30, 10> translate <3 * mod(N, Columns) + 1.5, -3 * int(N / Columns) - 1.5, 0> #declare N = N + 1; #end
#declare Unit = box { -1.1, 1.1 }
object { Sphere Next() } object { Ellipsoid Next() } object { UnitBox scale 0.7 Next() } object { Cube scale 0.7 Next() }
object { Cylinder_X clipped_by { Unit } Next() } object { Cylinder_Y clipped_by { Unit } Next() } object { Cylinder_Z clipped_by { Unit } Next() }
object { QCone_X clipped_by { Unit } Next() } object { QCone_Y clipped_by { Unit } Next() } object { QCone_Z clipped_by { Unit } Next() }
object { Cone_X Next() } object { Cone_Y Next() } object { Cone_Z Next() }
object { Plane_XY clipped_by { Unit } Next() } object { Plane_XZ clipped_by { Unit } Next() } object { Plane_YZ clipped_by { Unit } Next() }
object { Paraboloid_X clipped_by { Unit } Next() } object { Paraboloid_Y clipped_by { Unit } Next() } object { Paraboloid_Z clipped_by { Unit } Next() }
object { Hyperboloid clipped_by { Unit } Next() } object { Hyperboloid_Y clipped_by { Unit } Next() }
object { Disk_X scale 0.7 Next() } object { Disk_Y scale 0.7 Next() } object { Disk_Z scale 0.7 Next() }
intersection { sphere { 0, 1.2 } Wedge(60) Next() } intersection { sphere { 0, 1.2 } Wedge(120) Next() } intersection { sphere { 0, 1.2 } Wedge(270) Next() }
object { Spheroid(<0.1, 0.2, 0>, <1, 0.5, 0.7>) Next() }
object { Connect_Spheres(<-0.7, 0, 0>, 0.6, <0.8, 0.2, 0>, 0.3) Next() }
object { Wire_Box(<-1, -0.7, -0.5>, <1, 0.7, 0.5>, 0.15, 0) Next() } object { Wire_Box(<-1, -0.7, -0.5>, <1, 0.7, 0.5>, 0.15, 1) Next() }
object { Round_Box(<-1, -0.7, -0.5>, <1, 0.7, 0.5>, 0.25, 0) Next() } object { Round_Box_Merge(<-1, -0.7, -0.5>, <1, 0.7, 0.5>, 0.25) Next() }
object { Round_Cylinder(<-0.8, -0.2, 0>, <0.8, 0.4, 0.1>, 0.7, 0.2, 0) Next() } object { Round_Cylinder_Merge(-y, y, 0.7, 0.2) Next() }
object { Round_Cone(<-0.8, -0.2, 0>, 0.9, <0.8, 0.4, 0.1>, 0.5, 0.15, 0) Next() } object { Round_Cone_Merge(-y, 0.4, y, 0.9, 0.2) Next() }
object { Round_Cone2(<-0.6, -0.2, 0>, 0.6, <0.8, 0.4, 0.1>, 0.3, 0) Next() } object { Round_Cone3(<-0.5, -0.2, 0>, 0.6, <0.7, 0.4, 0.1>, 0.3, 0) Next() }
union { Quad(<-1, -1, 0>, <1, -0.8, 0>, <0.9, 1, 0>, <-0.7, 0.8, 0>) Next() }
union { Smooth_Quad(<-1, -1, 0>, <-1, -1, -2>, <1, -0.8, 0>, <1, -1, -2>, <0.9, 1, 0>, <1, 1, -2>, <-0.7, 0.8, 0>, <-1, 1, -2>) Next() }
object { Supercone(<0, -1, 0>, 0.8, 0.4, <0, 1, 0>, 0.3, 0.6) Next() }
#macro Show(V) #debug concat("@", vstr(3, 0 + V, ", ", 0, 4), "\n") #end
#declare Ball = sphere { <1, 2, 3>, 0.5 }
#declare P = <0, 0, 0>;
#declare Q = <0, 0, 0>;
#declare Hit = Isect(<1, 2, -5>, z, Ball, P);
Show(Hit) Show(P)
#declare Hit = IsectN(<1.2, 2.1, -5>, z, Ball, P, Q);
Show(Hit) Show(P) Show(Q)
#declare Hit = Isect(<9, 2, -5>, z, Ball, P);
Show(Hit)
Extents(Ball, P, Q)
Show(P) Show(Q)
#declare C = Center_Object(Ball, x + z)
Show(min_extent(C))
#declare C = Align_Object(Ball, <1, -1, 0>, <7, 8, 9>)
Show(max_extent(C))
Show(Text_Width("timrom.ttf", "Hello", 2, 0))
Show(Text_Space("timrom.ttf", "Hello", 2, 0))
Show(Text_Width("timrom.ttf", "A", 1, 0))
Show(Text_Space("timrom.ttf", "A", 1, 0))
Show(Text_Space("timrom.ttf", "A b", 1, 0.1))
