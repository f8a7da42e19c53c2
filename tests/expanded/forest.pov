// Macros, loops and conditions build objects that share their parts.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -9> look_at <0, 1, 0> angle 45 }
light_source { <4, 8, -5>, 1 }
#macro Tree(Height)
  union {
    cylinder { 0, Height*y, 0.1 pigment { rgb <0.4, 0.25, 0.1> } }
    #for (I, 1, 3)
      cone { I*Height/4*y, 0.9 - I/5, (I + 1)*Height/4*y, 0 }
    #end
  }
#end
#declare Small = Tree(1)
#declare Leaves = texture { pigment { bozo color_map { [0 rgb <0, 0.5, 0>] [1 rgb <0.3, 0.7, 0.1>] } scale 0.2 } }
#declare Place = -3;
#while (Place <= 3)
  object {
    #if (mod(Place, 2) = 0) Small #else Tree(2) #end
    texture { Leaves }
    translate Place*x
  }
  #declare Place = Place + 1;
#end
