/**
 * Functions, calls and places in source text (manual, "Code", "Lazy", "CallMessage", "Location",
 * "StackFrame", "Profile").
 */
package org.urbi.kernel.library.code;
