// An #end without a beginning.
#if (1)
  sphere { 0, 1 }
#end
#end
