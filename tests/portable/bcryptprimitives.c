/* The one function of bcryptprimitives.dll that Rust's standard library uses, for versions of wine that lack
 * this part of Windows. */

#include <windows.h>

/* In advapi32, where it is called SystemFunction036. */
BOOLEAN NTAPI SystemFunction036(PVOID buffer, ULONG length);

__declspec(dllexport) BOOL WINAPI ProcessPrng(PBYTE buffer, SIZE_T length) {
    return SystemFunction036(buffer, (ULONG)length);
}
