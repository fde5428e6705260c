! The C interface from Fortran: a case file, and the full theory over a creep-force curve.
!
!   gfortran creep_force.f90 $(pkg-config --libs creepage) -o creep_force
!   ./creep_force CASE.toml
module creepage
  use, intrinsic :: iso_c_binding
  implicit none

  integer(c_int32_t), parameter :: creepage_ok = 0

  interface
    ! name, options: texts that end with c_null_char; a_over_b, poisson, kappa_over_mu (1).
    function creepage_theory_new(name, options, a_over_b, poisson, kappa_over_mu, theory, message, &
        message_size) bind(c) result(code)
      import
      character(kind=c_char), intent(in) :: name(*), options(*)
      real(c_double), value :: a_over_b, poisson, kappa_over_mu
      type(c_ptr), intent(out) :: theory
      character(kind=c_char), intent(out) :: message(*)
      integer(c_size_t), value :: message_size
      integer(c_int32_t) :: code
    end function

    subroutine creepage_theory_free(theory) bind(c)
      import
      type(c_ptr), value :: theory
    end subroutine

    ! creepages(3, n): xi, eta, chi (1); forces(3, n): f_x, f_y, m_z (1); statuses(n). errors of
    ! 3 n and derivatives of 9 n numbers: their addresses, or c_null_ptr.
    function creepage_theory_force(theory, count, creepages, forces, errors, derivatives, statuses, &
        message, message_size) bind(c) result(code)
      import
      type(c_ptr), value :: theory, errors, derivatives
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: creepages(3, *)
      real(c_double), intent(out) :: forces(3, *)
      integer(c_int32_t), intent(out) :: statuses(*)
      character(kind=c_char), intent(out) :: message(*)
      integer(c_size_t), value :: message_size
      integer(c_int32_t) :: code
    end function

    ! creepage(3): longitudinal, lateral (1), spin (rad/m), given or found; force(3): longitudinal
    ! (N), lateral (N), moment (N m); theory: c_null_ptr for the file's own.
    function creepage_case_solve(path, theory, creepage, force, status, message, message_size) &
        bind(c) result(code)
      import
      character(kind=c_char), intent(in) :: path(*)
      type(c_ptr), value :: theory
      real(c_double), intent(out) :: creepage(3), force(3)
      integer(c_int32_t), intent(out) :: status
      character(kind=c_char), intent(out) :: message(*)
      integer(c_size_t), value :: message_size
      integer(c_int32_t) :: code
    end function
  end interface
end module

program creep_force
  use creepage
  implicit none

  integer, parameter :: cases = 5
  integer(c_size_t), parameter :: room = 256
  character(kind=c_char) :: message(room)
  character(len=1024) :: path
  type(c_ptr) :: theory
  real(c_double) :: slip(3), force(3), creepages(3, cases), forces(3, cases)
  integer(c_int32_t) :: status, statuses(cases)
  integer :: k

  call get_command_argument(1, path)
  call check(creepage_case_solve(trim(path)//c_null_char, c_null_ptr, slip, force, status, &
      message, room))
  print '(a, 3(1x, es24.16e3))', 'case', force

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
