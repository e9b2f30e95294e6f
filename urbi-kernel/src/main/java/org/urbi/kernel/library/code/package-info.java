/**
 * Functions, calls and places in source text (manual, "Code", "Lazy", "CallMessage", "Location",
 * "StackFrame", "Profile").
 */
@NullMarked
package org.urbi.kernel.library.code;

import org.jspecify.annotations.NullMarked;
