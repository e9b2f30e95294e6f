/** From syntax tree to text. */
package org.urbi.lang.print;
