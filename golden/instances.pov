// Declared objects used again and again: a hundred copies of one compound, each with its own transform.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 6, -9> look_at <0, 0, 0> angle 40 }
light_source { <-5, 9, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

#declare Peg = difference {
  union { cylinder { 0, 0.6 * y, 0.2 } sphere { 0.6 * y, 0.3 } }
  box { <-1, 0.4, -0.05>, <1, 2, 0.05> }
}
#for (J, 0, 9) #for (I, 0, 9)
  object {
    Peg
    rotate (I * 36 + J * 20) * y
    scale <1, 0.5 + 0.1 * I, 1>
    translate <I - 4.5, 0, J - 4.5> * 0.8
    pigment { rgb <0.2 + 0.08 * I, 0.4, 0.2 + 0.08 * J> }
  }
#end #end
