/** What time it is: the only room of these that looks at the machine's clock. */
package urbi.time;
