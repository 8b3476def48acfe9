@echo off
rem The course's one command for PowerShell and cmd: course.cmd check 01.1 does what ./course check 01.1 does in the
rem UCRT64 window of MSYS2. If MSYS2 is in none of these folders, the variable MSYS2 names its folder.
setlocal
set "found="
for %%f in (
    "%MSYS2%"
    "%SystemDrive%\msys64"
    "%SystemDrive%\tools\msys64"
    "%USERPROFILE%\scoop\apps\msys2\current"
) do if not defined found if not "%%~f"=="" if exist "%%~f\usr\bin\bash.exe" set "found=%%~f"
if not defined found (
    >&2 echo course: MSYS2 is missing: type winget install MSYS2.MSYS2, or set MSYS2 to the folder where you have it
    exit /b 1
)
set MSYSTEM=UCRT64
set CHERE_INVOKING=yes
set "here=%~dp0"
set "here=%here:\=/%"
"%found%\usr\bin\bash.exe" -lc "exec \"$0\" \"$@\"" "%here%course" %*
