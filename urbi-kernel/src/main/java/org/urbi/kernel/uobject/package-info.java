/**
 * UObjects plugged into the kernel: the context they live in, their modules, and the conversion of
 * what passes between them and urbiscript (manual, "The UObject API").
 */
package org.urbi.kernel.uobject;
