/**
 * UObjects plugged into the kernel: their context, their modules, and the conversion of values
 * between them and urbiscript (manual, "The UObject API").
 */
@NullMarked
package org.urbi.kernel.uobject;

import org.jspecify.annotations.NullMarked;
