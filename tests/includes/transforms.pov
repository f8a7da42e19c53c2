// Each transform macro, seen through what it does to four points.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "transforms.inc"
#macro Show(V) #debug concat("@", vstr(3, 0 + V, ", ", 0, 8), "\n") #end
#declare Points = array[4] { <0, 0, 0>, <1, 2, 3>, <-2, 0.5, 1>, <0.3, -1, -4> }
#macro Through(T)
  #for (K, 0, 3)
    Show(vtransform(Points[K], T))
    Show(vinv_transform(Points[K], T))
  #end
#end

Through(transform { rotate <10, 20, 30> translate <1, 2, 3> scale <2, 1, 0.5> })
Through(Shear_Trans(<1, 0.2, 0>, <0, 1, 0.5>, <0.3, 0, 2>))
Through(Matrix_Trans(<1, 0.2, 0>, <0, 1, 0.5>, <0.3, 0, 2>, <4, 5, 6>))
Through(Axial_Scale_Trans(<1, 1, 0>, 3))
Through(Axial_Scale_Trans(<0.3, -1, 2>, 0.25))
Through(Axis_Rotate_Trans(<1, 2, 3>, 77))
Through(Axis_Rotate_Trans(y, -30))
Through(Rotate_Around_Trans(<10, 20, 30>, <5, 4, 3>))
Through(Reorient_Trans(<1, 2, 3>, <-2, 0.5, 1>))
Through(Reorient_Trans(x, z))
Through(Reorient_Trans(y, 3 * y))
Through(Point_At_Trans(<1, 2, 3>))
Through(Point_At_Trans(<-1, 0.2, 0.1>))
Through(Point_At_Trans(<0.1, -1, 0.3>))

#declare Thing = union { box { <1, 2, 3>, <4, 6, 9> } sphere { <0, 0, 1>, 0.5 } }
Through(Center_Trans(Thing, x))
Through(Center_Trans(Thing, y + z))
Through(Center_Trans(Thing, x + y + z))
Through(Align_Trans(Thing, x, <7, 8, 9>))
Through(Align_Trans(Thing, -x, <7, 8, 9>))
Through(Align_Trans(Thing, <-1, 1, 0>, <7, 8, 9>))
Through(Align_Trans(Thing, <1, 0, -1>, <7, 8, 9>))

#declare Way = spline { natural_spline 0, <0, 0, 0> 1, <2, 1, 1> 2, <3, 0, 4> 3, <0, 2, 5> }
#for (T, 0.2, 2.6, 0.6)
  Through(Spline_Trans(Way, T, y, 0.1, 0))
  Through(Spline_Trans(Way, T, y, 0.1, 0.5))
#end
