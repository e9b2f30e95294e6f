/**
 * UObjects plugged into the kernel: the context they live in, their modules, and the conversion of
 * what passes between them and urbiscript (manual, "The UObject API").
 */
@NullMarked
package org.urbi.kernel.uobject;

import org.jspecify.annotations.NullMarked;
