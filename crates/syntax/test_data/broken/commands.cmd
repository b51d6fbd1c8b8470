force create element_like beam  &
   length = ixx = 4  &
   comments = "never closed &
   iyy = 3
marker create  location = 1,, 2 stray words  &
   orientation = (1 + * 2), (3  &
   adams_id = 1
part_name = .m.p
variable set  real_value = SIN(30)  integer_value = 1e400
file read  file_name = "C:\models\"
a & b
