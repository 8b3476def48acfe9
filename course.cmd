@echo off
rem The course's one command for PowerShell and cmd: course.cmd check 01.1 does what ./course check 01.1 does in the
rem UCRT64 window of MSYS2. If MSYS2 is not in C:\msys64, the variable MSYS2 names its folder.
setlocal
if not defined MSYS2 set "MSYS2=C:\msys64"
if not exist "%MSYS2%\usr\bin\bash.exe" (
    echo course: MSYS2 is missing: install it from https://www.msys2.org, or set MSYS2 to its folder 1>&2
    exit /b 1
)
set MSYSTEM=UCRT64
set CHERE_INVOKING=yes
set "here=%~dp0"
set "here=%here:\=/%"
"%MSYS2%\usr\bin\bash.exe" -lc "exec \"$0\" \"$@\"" "%here%course" %*
