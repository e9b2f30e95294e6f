/**
 * How the library is declared: annotations on plain Java methods, and the annotation processor that
 * turns them into tables when the kernel is compiled, so that starting a kernel needs neither
 * reflection nor a scan.
 *
 * <p>This module is needed at compile time only and knows the kernel's classes by name.
 */
@NullMarked
package org.urbi.builtins;

import org.jspecify.annotations.NullMarked;
