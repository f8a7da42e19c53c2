// trace, inside, min_extent and max_extent: beads where rays meet a shape, and a frame around its box.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

#declare Egg = union {
  ovus { 0.9, 0.5 }
  cone { <-1.4, -0.6, 0>, 0.5, <-0.6, 0.3, 0.2>, 0.1 }
  rotate <15, 20, 25>
}
object { Egg pigment { rgb <0.8, 0.6, 0.4> } }
#declare N = <0, 0, 0>;
#for (I, -6, 6)
  #for (J, -4, 4)
    #local P = trace(Egg, <I * 0.3, J * 0.3, -5>, z, N);
    #if (vlength(N) > 0)
      sphere { P + 0.1 * N, 0.06 pigment { rgb 0.5 + 0.5 * N } }
    #else
      #if (inside(Egg, <I * 0.3, J * 0.3, 0>)) sphere { <I * 0.3, J * 0.3, 0>, 0.1 pigment { rgb 1 } } #end
    #end
  #end
#end
#declare A = min_extent(Egg);
#declare B = max_extent(Egg);
cylinder { <A.x, A.y, A.z>, <B.x, A.y, A.z>, 0.04 pigment { rgb 1 } }
cylinder { <A.x, B.y, A.z>, <B.x, B.y, A.z>, 0.04 pigment { rgb 1 } }
cylinder { <A.x, A.y, A.z>, <A.x, B.y, A.z>, 0.04 pigment { rgb 1 } }
cylinder { <B.x, A.y, A.z>, <B.x, B.y, A.z>, 0.04 pigment { rgb 1 } }
