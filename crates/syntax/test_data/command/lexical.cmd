! CMD Version:2
! One statement per logical line; a mark at the end of a line continues it.
defaults units  &
   length = mm  &   ! comment behind a mark
   ! label = "commented out" &
   angle = deg force=newton&
   time = sec
!
if condition = (! db_exists(".colors.SKY"))  ! a `!` in parentheses is no comment
   color create  color_name = .colors.SKY  &
      red_component = 0.2, .3 &
      , 1.0E-002

.colors.SKY.components = 0.961, 0.871, &
   0.702
end  ! end of if
script create  commands =  &
   "!
SIMULATE/DYNAMIC, END=1 &
, STEPS=10
"
