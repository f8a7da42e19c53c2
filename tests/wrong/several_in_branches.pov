// Errors in branches, loops and a switch; the brace of the first object is missing.
#version 3.7;
sphere { 0, 1
plane { y, -1 }
#switch (1)
  #case (1)
    sphere { 0, One }
  #break
  #case (2)
    sphere { 0, Two }
  #break
#end
#if (0)
  box { 0, }
#else
  box { 0, <1, 2 }
  disc { 0, y }
#end
#for (I, 1, 5)
  union {
    #if (I > 2) sphere { I, I, I } #end
    box { 0, 1 }
  }
#end
light_source { 1, rbg 1 }
