// Arrays chosen from, resized, reversed and sorted.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "arrays.inc"
#declare R = seed(12);
#macro Show(A) #for (K, 0, dimension_size(A, 1) - 1) #debug concat("@", str(A[K], 0, 6), "\n") #end #end
#for (Size, 1, 12)
  #declare A = array[Size]
  #for (I, 0, Size - 1) #declare A[I] = int(100 * rand(R)); #end
  Show(A)
  #debug concat("@", str(Rand_Array_Item(A, R), 0, 6), "\n")
  Reverse_Array(A)
  Show(A)
  Sort_Array(A)
  Show(A)
  Resize_Array(A, Size + 2)
  #declare A[Size] = -5;
  #declare A[Size + 1] = 7;
  Sort_Partial_Array(A, 1, Size + 1)
  Show(A)
  Resize_Array(A, max(1, Size - 1))
  Show(A)
#end
