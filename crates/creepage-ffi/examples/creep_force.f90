! The C interface from Fortran: a case file, a history in SI units, and the full theory over a
! creep-force curve.
!
!   gfortran $(pkg-config --variable=includedir creepage)/creepage.f90 creep_force.f90 \
!     $(pkg-config --libs creepage) -o creep_force
!   ./creep_force CASE.toml
program creep_force
  use creepage
  implicit none

  integer, parameter :: cases = 5
  integer(c_size_t), parameter :: room = 256
  character(kind=c_char) :: message(room)
  character(len=1024) :: path
  type(c_ptr) :: theory, made
  real(c_double) :: slip(3), force(3), creepages(3, cases), forces(3, cases)
  real(c_double) :: loads(1, 2)
  integer(c_int32_t) :: status, statuses(cases)
  integer :: k

  call get_command_argument(1, path)
  call check(creepage_case_solve(trim(path)//c_null_char, c_null_ptr, slip, force, status, &
      message, room))
  print '(a, 3(1x, es24.16e3))', 'case', force

  loads(1, :) = [70e3_c_double, 90e3_c_double]
  call check(creepage_case_new(trim(path)//c_null_char, c_null_ptr, made, message, room))
  call check(creepage_case_force(made, c_null_ptr, 'normal_force'//c_null_char, 2_c_size_t, loads, &
      forces, c_null_ptr, c_null_ptr, c_null_ptr, statuses, message, room))
  call creepage_case_free(made)
  print '(a, 6(1x, es24.16e3))', 'history', forces(:, 1:2)

  creepages = 0
  creepages(1, :) = [(0.5_c_double * k, k = 1, cases)]
  call check(creepage_theory_new('exact'//c_null_char, "resolution = 'fast'"//c_null_char, &
      1.5_c_double, 0.28_c_double, 0.0_c_double, theory, message, room))
  call check(creepage_theory_force(theory, int(cases, c_size_t), creepages, forces, c_null_ptr, &
      c_null_ptr, statuses, message, room))
  call creepage_theory_free(theory)
  do k = 1, cases
    print '(a, 4(1x, es24.16e3))', 'curve', creepages(1, k), forces(:, k)
  end do

contains

  ! Ends the program with the library's words if a call failed.
  subroutine check(code)
    integer(c_int32_t), intent(in) :: code
    integer :: i
    if (code == creepage_ok) return
    do i = 1, int(room)
      if (message(i) == c_null_char) exit
      write (*, '(a)', advance='no') message(i)
    end do
    print *
    error stop 1
  end subroutine
end program
