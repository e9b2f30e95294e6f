/** From text to syntax tree. */
package org.urbi.lang.parse;
