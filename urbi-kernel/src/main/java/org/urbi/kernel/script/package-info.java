/** urbiscript as a scripting language of the Java platform (JSR 223). */
package org.urbi.kernel.script;
